/// The menu, or the part of one between two lines, that a command is listed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// File.
    File,
    /// File ▸ Built-in Scene.
    Scenes,
    /// Insert, first part.
    Insert,
    /// Insert, the part with curves.
    Curves,
    /// Insert ▸ Import.
    Import,
    /// View, first part.
    View,
    /// View ▸ Look.
    Look,
    /// View ▸ Shading.
    Shading,
    /// View, last part.
    Ground,
    /// View, the line about comparing.
    Compare,
    /// View ▸ Navigation.
    Navigation,
    /// View ▸ Theme.
    Theme,
    /// View ▸ Skinning.
    Skinning,
    /// Pose, the tools.
    Tools,
    /// Pose, the part about the whole pose.
    Pose,
    /// Help.
    Help,
    /// The shape panel's buttons, and the signs in its list.
    Shape,
}

impl Menu {
    /// All, in the order of the window about the keys.
    pub const ALL: &[Self] = &[
        Self::File,
        Self::Scenes,
        Self::Insert,
        Self::Curves,
        Self::Import,
        Self::Shape,
        Self::View,
        Self::Look,
        Self::Shading,
        Self::Ground,
        Self::Compare,
        Self::Navigation,
        Self::Theme,
        Self::Skinning,
        Self::Tools,
        Self::Pose,
        Self::Help,
    ];
}
