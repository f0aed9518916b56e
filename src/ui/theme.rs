use egui::layers::ShapeIdx;
use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Frame, LayerId, Margin, Shadow, Shape,
    Stroke, Style, TextStyle, Theme, Visuals, vec2,
};

/// The colors of one theme. Text is at least 4.5 : 1 against everything it stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Behind panels, menus and windows.
    pub panel: Color32,
    /// Behind numbers, buttons and lists at rest.
    pub field: Color32,
    /// The same under the pointer.
    pub field_hovered: Color32,
    /// The same while it is held or has the keyboard.
    pub field_active: Color32,
    /// Behind text that is being typed.
    pub typing: Color32,
    /// Between panels and around fields.
    pub line: Color32,
    /// Ordinary text.
    pub text: Color32,
    /// Text that stands out: titles, changed joints.
    pub strong: Color32,
    /// Less important text: units, hints.
    pub weak: Color32,
    /// Numbers that are as they were at rest.
    pub rest: Color32,
    /// The one accent: keyboard focus, marks.
    pub accent: Color32,
    /// Behind what is selected.
    pub selection: Color32,
    /// Text on [`Palette::selection`].
    pub on_selection: Color32,
    /// The letters X, Y and Z.
    pub axes: [Color32; 3],
    /// Text of warnings.
    pub warning: Color32,
    /// Text of errors.
    pub error: Color32,
}

/// For work in the dark, a step lighter than the Course look's background.
pub const DARK: Palette = Palette {
    panel: Color32::from_rgb(0x26, 0x27, 0x2a),
    field: Color32::from_rgb(0x36, 0x38, 0x3c),
    field_hovered: Color32::from_rgb(0x41, 0x44, 0x49),
    field_active: Color32::from_rgb(0x49, 0x4c, 0x52),
    typing: Color32::from_rgb(0x18, 0x19, 0x1b),
    line: Color32::from_rgb(0x3f, 0x42, 0x47),
    text: Color32::from_rgb(0xdc, 0xde, 0xe1),
    strong: Color32::from_rgb(0xff, 0xff, 0xff),
    weak: Color32::from_rgb(0xb4, 0xb8, 0xbf),
    rest: Color32::from_rgb(0xa2, 0xa6, 0xae),
    accent: Color32::from_rgb(0x73, 0xb6, 0xfa),
    selection: Color32::from_rgb(0x2a, 0x57, 0x8c),
    on_selection: Color32::from_rgb(0xff, 0xff, 0xff),
    axes: [
        Color32::from_rgb(0xff, 0x9a, 0x92),
        Color32::from_rgb(0x8f, 0xd1, 0x6f),
        Color32::from_rgb(0x82, 0xba, 0xff),
    ],
    warning: Color32::from_rgb(0xff, 0xc1, 0x5c),
    error: Color32::from_rgb(0xff, 0xa1, 0x9a),
};

/// For bright rooms and projectors.
pub const LIGHT: Palette = Palette {
    panel: Color32::from_rgb(0xf2, 0xf3, 0xf5),
    field: Color32::from_rgb(0xff, 0xff, 0xff),
    field_hovered: Color32::from_rgb(0xe9, 0xee, 0xf5),
    field_active: Color32::from_rgb(0xdf, 0xe7, 0xf1),
    typing: Color32::from_rgb(0xff, 0xff, 0xff),
    line: Color32::from_rgb(0xc6, 0xca, 0xd0),
    text: Color32::from_rgb(0x1f, 0x23, 0x28),
    strong: Color32::from_rgb(0x00, 0x00, 0x00),
    weak: Color32::from_rgb(0x4d, 0x53, 0x5b),
    rest: Color32::from_rgb(0x64, 0x6a, 0x73),
    accent: Color32::from_rgb(0x0b, 0x5c, 0xb8),
    selection: Color32::from_rgb(0xc9, 0xdf, 0xf9),
    on_selection: Color32::from_rgb(0x06, 0x2f, 0x63),
    axes: [
        Color32::from_rgb(0xa8, 0x1c, 0x14),
        Color32::from_rgb(0x25, 0x61, 0x18),
        Color32::from_rgb(0x17, 0x52, 0xad),
    ],
    warning: Color32::from_rgb(0x7a, 0x4a, 0x00),
    error: Color32::from_rgb(0xa8, 0x1c, 0x14),
};

impl Palette {
    /// The palette that `visuals` were made from.
    pub fn of(visuals: &Visuals) -> &'static Self {
        if visuals.dark_mode { &DARK } else { &LIGHT }
    }
}

/// The letters of numbers: a little smaller, so that three fields fit beside a name.
pub(super) fn number_font() -> FontId {
    FontId::proportional(12.5)
}

/// Gives both of egui's themes the program's fonts, spacing and colors; rows and buttons are higher `for_fingers`.
pub(super) fn apply(ctx: &Context, for_fingers: bool) {
    for (theme, palette) in [(Theme::Dark, &DARK), (Theme::Light, &LIGHT)] {
        ctx.style_mut_of(theme, |style| {
            set_spacing(style);
            if for_fingers {
                style.spacing.button_padding.y = 5.0;
                style.spacing.interact_size.y = 28.0;
                style.spacing.item_spacing.y = 6.0;
            }
            set_colors(&mut style.visuals, palette);
        });
    }
}

/// Everything on a grid of 4 points, with 2 between things that belong together.
fn set_spacing(style: &mut Style) {
    let text = |size| FontId::new(size, FontFamily::Proportional);
    style.text_styles = [
        (TextStyle::Small, text(12.0)),
        (TextStyle::Body, text(14.0)),
        (TextStyle::Button, text(14.0)),
        (TextStyle::Heading, text(16.0)),
        (
            TextStyle::Monospace,
            FontId::new(13.0, FontFamily::Monospace),
        ),
    ]
    .into();
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(4.0, 4.0);
    spacing.button_padding = vec2(8.0, 1.0);
    spacing.interact_size = vec2(40.0, 20.0);
    spacing.window_margin = Margin::same(12);
    spacing.menu_margin = Margin::same(4);
    spacing.indent = 16.0;
    spacing.icon_width = 16.0;
    spacing.icon_width_inner = 10.0;
    spacing.icon_spacing = 6.0;
    spacing.tooltip_width = 320.0;
    spacing.combo_height = 320.0;
    spacing.scroll = egui::style::ScrollStyle {
        bar_width: 8.0,
        floating_width: 4.0,
        floating_allocated_width: 8.0,
        ..egui::style::ScrollStyle::thin()
    };
    style.interaction.selectable_labels = false;
    style.interaction.tooltip_delay = 0.7;
}

/// Shows a file dialog, which paints into `layer`, in colors in which all of it can be read: it writes
/// in the color of the selection, and its fields are black in every theme.
pub fn in_colors_of_file_dialogs(context: &Context, layer: LayerId, show: impl FnOnce()) {
    let theme = context.theme();
    let own = context.style_of(theme);
    let palette = Palette::of(&own.visuals);
    let mut style = Style::clone(&own);
    style.visuals.selection.bg_fill = palette.accent;
    style.visuals.selection.stroke.color = palette.panel;
    context.set_style_of(theme, style);
    show();
    let black = Frame::dark_canvas(&own).fill;
    context.set_style_of(theme, own);
    context.graphics_mut(|layers| {
        let painted = layers.entry(layer);
        for index in 0..painted.next_idx().0 {
            painted.mutate_shape(ShapeIdx(index), |painted| {
                if let Shape::Rect(field) = &mut painted.shape
                    && field.fill == black
                {
                    field.fill = palette.typing;
                }
            });
        }
    });
}

fn set_colors(visuals: &mut Visuals, palette: &Palette) {
    *visuals = if *palette == LIGHT {
        Visuals::light()
    } else {
        Visuals::dark()
    };
    visuals.text_cursor.blink = false;
    visuals.panel_fill = palette.panel;
    visuals.window_fill = palette.panel;
    visuals.window_stroke = Stroke::new(1.0, palette.line);
    visuals.window_corner_radius = CornerRadius::same(6);
    visuals.window_highlight_topmost = false;
    visuals.menu_corner_radius = CornerRadius::same(4);
    let shadow = Shadow {
        offset: [0, 4],
        blur: 12,
        spread: 0,
        color: Color32::from_black_alpha(if visuals.dark_mode { 96 } else { 40 }),
    };
    visuals.window_shadow = shadow;
    visuals.popup_shadow = shadow;
    visuals.extreme_bg_color = palette.typing;
    visuals.faint_bg_color = palette.field;
    visuals.weak_text_color = Some(palette.weak);
    visuals.warn_fg_color = palette.warning;
    visuals.error_fg_color = palette.error;
    visuals.hyperlink_color = palette.accent;
    visuals.selection.bg_fill = palette.selection;
    visuals.selection.stroke = Stroke::new(1.0, palette.on_selection);
    visuals.text_cursor.stroke = Stroke::new(1.0, palette.strong);

    let widgets = &mut visuals.widgets;
    for (widget, fill, text, stroke) in [
        (
            &mut widgets.noninteractive,
            palette.panel,
            palette.text,
            palette.line,
        ),
        (
            &mut widgets.inactive,
            palette.field,
            palette.text,
            palette.line,
        ),
        (
            &mut widgets.hovered,
            palette.field_hovered,
            palette.strong,
            palette.line,
        ),
        (
            &mut widgets.active,
            palette.field_active,
            palette.strong,
            palette.accent,
        ),
        (
            &mut widgets.open,
            palette.field,
            palette.strong,
            palette.line,
        ),
    ] {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = Stroke::new(1.0, stroke);
        widget.fg_stroke = Stroke::new(1.0, text);
        widget.corner_radius = CornerRadius::same(3);
        widget.expansion = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of WCAG 2.2.
    fn luminance(color: Color32) -> f64 {
        let linear = |channel: u8| {
            let c = f64::from(channel) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        };
        0.2126 * linear(color.r()) + 0.7152 * linear(color.g()) + 0.0722 * linear(color.b())
    }

    fn contrast(a: Color32, b: Color32) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn contrast_is_21_between_black_and_white_and_1_between_equals() {
        assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-9);
        assert!((contrast(DARK.accent, DARK.accent) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn every_text_is_at_least_4_5_to_1_against_whatever_it_stands_on() {
        for (name, p) in [("dark", DARK), ("light", LIGHT)] {
            let texts = [
                p.text, p.strong, p.weak, p.axes[0], p.axes[1], p.axes[2], p.warning, p.error,
                p.accent,
            ];
            let grounds = [p.panel, p.field, p.typing, p.field_hovered];
            for (t, text) in texts.into_iter().enumerate() {
                for (g, ground) in grounds.into_iter().enumerate() {
                    let contrast = contrast(text, ground);
                    assert!(
                        contrast >= 4.5,
                        "{name}: text {t} on ground {g}: {contrast:.2}"
                    );
                }
            }
            assert!(
                contrast(p.on_selection, p.selection) >= 4.5,
                "{name}: selection"
            );
            // Fields at rest are dim only while they are not used.
            for ground in [p.panel, p.field] {
                let contrast = contrast(p.rest, ground);
                assert!(contrast >= 4.5, "{name}: at rest: {contrast:.2}");
            }
            assert!(contrast(p.text, p.field_active) >= 4.5, "{name}: active");
        }
    }
}
