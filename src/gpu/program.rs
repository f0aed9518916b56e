//! Shader programs. One body serves OpenGL 3.3 and OpenGL ES 3.0: the header is added here.

use std::cell::{OnceCell, RefCell};
use std::collections::{BTreeSet, HashMap};

use glam::{Mat3, Mat4, Vec2, Vec3};
use glow::HasContext as _;

use super::{Gl, GpuError};

/// `#line 1` makes the driver count from the first line of the body.
const GL_HEADER: &str = "#version 330 core\n#line 1\n";
const GLES_HEADER: &str = "#version 300 es\n\
     precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n#line 1\n";

struct Uniform {
    location: glow::UniformLocation,
    kind: u32,
}

/// A linked vertex and fragment shader with its uniforms.
///
/// Uniforms are set by name and keep their value until set again. A name that the source declares
/// but the driver removed as unused is ignored; one that the source never declares, or a value of
/// the wrong type, is a fault that [`Gl::check`] returns.
#[doc(alias = "ShaderLoader")]
pub struct Program {
    gl: Gl,
    label: String,
    /// Bodies of the vertex and the fragment shader.
    bodies: [String; 2],
    /// `None` if the driver refused it.
    linked: OnceCell<Option<Linked>>,
    unknown: RefCell<BTreeSet<String>>,
}

/// What the driver made of the shaders.
struct Linked {
    raw: glow::Program,
    uniforms: HashMap<String, Uniform>,
    declared: BTreeSet<String>,
}

impl std::fmt::Debug for Program {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Program").field(&self.label).finish()
    }
}

impl Program {
    /// Compiles and links. Bodies have no `#version` line and stay within what OpenGL 3.3 and
    /// OpenGL ES 3.0 share (`1.0`, never `1`); `label` is the name in errors.
    ///
    /// # Errors
    /// [`GpuError::Compile`] and [`GpuError::Link`] with the driver's text.
    pub fn new(
        gl: &Gl,
        label: &str,
        vertex_body: &str,
        fragment_body: &str,
    ) -> Result<Self, GpuError> {
        let program = Self::when_used(gl, label, vertex_body, fragment_body);
        let linked = program.link()?;
        program.linked.get_or_init(|| Some(linked));
        Ok(program)
    }

    /// As [`Program::new`], but compiles and links when it is first used: most programs are not needed for
    /// the first picture. Then it draws nothing if the driver refuses it, which [`Gl::check`] returns.
    pub fn when_used(gl: &Gl, label: &str, vertex_body: &str, fragment_body: &str) -> Self {
        Self {
            gl: gl.clone(),
            label: label.to_owned(),
            bodies: [vertex_body, fragment_body].map(str::to_owned),
            linked: OnceCell::new(),
            unknown: RefCell::default(),
        }
    }

    fn link(&self) -> Result<Linked, GpuError> {
        let (gl, label) = (&self.gl, &self.label);
        let [vertex_body, fragment_body] = &self.bodies;
        let vertex = Shader::compile(gl, label, glow::VERTEX_SHADER, vertex_body)?;
        let fragment = Shader::compile(gl, label, glow::FRAGMENT_SHADER, fragment_body)?;
        let create = |why| GpuError::Create {
            what: "shader program",
            why,
        };
        let glow = gl.current_for("making a shader program")?;
        // SAFETY: current context.
        let raw = unsafe { glow.create_program() }.map_err(create)?;
        // SAFETY: current context; the objects are of this context and alive.
        unsafe {
            glow.attach_shader(raw, vertex.raw);
            glow.attach_shader(raw, fragment.raw);
            glow.link_program(raw);
            glow.detach_shader(raw, vertex.raw);
            glow.detach_shader(raw, fragment.raw);
            if !glow.get_program_link_status(raw) {
                let log = glow.get_program_info_log(raw).trim().to_owned();
                glow.delete_program(raw);
                return Err(GpuError::Link {
                    label: label.to_owned(),
                    log,
                });
            }
        }
        let bodies = self.bodies.iter();
        Ok(Linked {
            raw,
            // SAFETY: current context; the program was linked.
            uniforms: unsafe { active_uniforms(glow, raw) },
            declared: bodies.flat_map(|body| declared_uniforms(body)).collect(),
        })
    }

    /// The linked program; `None` if the driver refuses it, or the context cannot be made current.
    fn linked(&self) -> Option<&Linked> {
        if let Some(linked) = self.linked.get() {
            return linked.as_ref();
        }
        let linked = match self.link() {
            Ok(linked) => Some(linked),
            Err(why) => {
                self.gl.report(why.to_string());
                if matches!(why, GpuError::Lost { .. }) {
                    // It may come back.
                    return None;
                }
                None
            }
        };
        self.linked.get_or_init(|| linked).as_ref()
    }

    /// The name given at creation.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// The entry points, with this program bound in them: draws use it from now on.
    pub(in crate::gpu) fn bind(&self) -> Option<&glow::Context> {
        let linked = self.linked()?;
        let glow = self.gl.current()?;
        // SAFETY: current context; the program is linked and alive.
        unsafe { glow.use_program(Some(linked.raw)) }
        Some(glow)
    }

    /// Whether it is an object of the context of `gl`.
    pub(in crate::gpu) fn is_of(&self, gl: &Gl) -> bool {
        self.gl.is_same(gl)
    }

    /// Sets a `float`.
    pub fn set_f32(&self, name: &str, value: f32) {
        // SAFETY: `set` passes a current context in which this program is bound, and a location of
        // this program whose type it has checked.
        self.set(name, &[glow::FLOAT], |gl, at| unsafe {
            gl.uniform_1_f32(Some(at), value)
        });
    }

    /// Sets an `int` or a `bool`.
    pub fn set_i32(&self, name: &str, value: i32) {
        // SAFETY: as in `set_f32`.
        self.set(name, &[glow::INT, glow::BOOL], |gl, at| unsafe {
            gl.uniform_1_i32(Some(at), value)
        });
    }

    /// Sets the first elements of an array of `int`, which has at least so many.
    pub fn set_i32s(&self, name: &str, values: &[i32]) {
        // SAFETY: as in `set_f32`; the driver ignores elements beyond the array's end.
        self.set(name, &[glow::INT], |gl, at| unsafe {
            gl.uniform_1_i32_slice(Some(at), values)
        });
    }

    /// Sets a `vec2`.
    pub fn set_vec2(&self, name: &str, v: Vec2) {
        // SAFETY: as in `set_f32`.
        self.set(name, &[glow::FLOAT_VEC2], |gl, at| unsafe {
            gl.uniform_2_f32(Some(at), v.x, v.y)
        });
    }

    /// Sets a `vec3`.
    pub fn set_vec3(&self, name: &str, v: Vec3) {
        // SAFETY: as in `set_f32`.
        self.set(name, &[glow::FLOAT_VEC3], |gl, at| unsafe {
            gl.uniform_3_f32(Some(at), v.x, v.y, v.z)
        });
    }

    /// Sets a `mat3`.
    pub fn set_mat3(&self, name: &str, value: Mat3) {
        let columns = value.to_cols_array();
        let kinds = &[glow::FLOAT_MAT3];
        // SAFETY: as in `set_f32`.
        self.set(name, kinds, |gl, at| unsafe {
            gl.uniform_matrix_3_f32_slice(Some(at), false, &columns)
        });
    }

    /// Sets a `mat4`.
    pub fn set_mat4(&self, name: &str, value: Mat4) {
        let columns = value.to_cols_array();
        let kinds = &[glow::FLOAT_MAT4];
        // SAFETY: as in `set_f32`.
        self.set(name, kinds, |gl, at| unsafe {
            gl.uniform_matrix_4_f32_slice(Some(at), false, &columns)
        });
    }

    /// Lets a `sampler2D` read the texture bound to `unit`.
    pub fn set_sampler(&self, name: &str, unit: u32) {
        let unit = i32::try_from(unit).unwrap_or(i32::MAX);
        // SAFETY: as in `set_f32`.
        self.set(name, &[glow::SAMPLER_2D], |gl, at| unsafe {
            gl.uniform_1_i32(Some(at), unit)
        });
    }

    /// Calls `set` with the program bound, if it has a uniform of this name and one of `kinds`.
    fn set(&self, name: &str, kinds: &[u32], set: impl Fn(&glow::Context, &glow::UniformLocation)) {
        let Some(linked) = self.linked() else {
            return;
        };
        match linked.uniforms.get(name) {
            Some(uniform) if kinds.contains(&uniform.kind) => {
                if let Some(glow) = self.bind() {
                    set(glow, &uniform.location);
                }
            }
            Some(_) => self.complain(name, "has another type than the value set"),
            None if linked.declared.contains(name) => {}
            None => self.complain(name, "is declared nowhere"),
        }
    }

    fn complain(&self, name: &str, problem: &str) {
        if self.unknown.borrow_mut().insert(name.to_owned()) {
            self.gl
                .report(format!("shader {}: uniform {name} {problem}", self.label));
        }
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let Some(Some(linked)) = self.linked.get() else {
            return;
        };
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context; deleted once.
            unsafe {
                // A program in use would stay until another one is.
                glow.use_program(None);
                glow.delete_program(linked.raw);
            }
        }
    }
}

/// A compiled stage. Once the program is linked it is no longer needed.
struct Shader<'a> {
    gl: &'a Gl,
    raw: glow::Shader,
}

impl<'a> Shader<'a> {
    fn compile(gl: &'a Gl, label: &str, kind: u32, body: &str) -> Result<Self, GpuError> {
        let header = if gl.info().is_gles {
            GLES_HEADER
        } else {
            GL_HEADER
        };
        let create = |why| GpuError::Create {
            what: "shader",
            why,
        };
        let glow = gl.current_for("compiling a shader")?;
        // SAFETY: current context.
        let shader = Self {
            gl,
            raw: unsafe { glow.create_shader(kind) }.map_err(create)?,
        };
        // SAFETY: current context; the shader is of this context and alive.
        let log = unsafe {
            glow.shader_source(shader.raw, &format!("{header}{body}"));
            glow.compile_shader(shader.raw);
            if glow.get_shader_compile_status(shader.raw) {
                return Ok(shader);
            }
            glow.get_shader_info_log(shader.raw)
        };
        Err(GpuError::Compile {
            label: label.to_owned(),
            stage: if kind == glow::VERTEX_SHADER {
                "vertex"
            } else {
                "fragment"
            },
            line: error_line(&log),
            log: log.trim().to_owned(),
        })
    }
}

impl Drop for Shader<'_> {
    fn drop(&mut self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context; deleted once.
            unsafe { glow.delete_shader(self.raw) }
        }
    }
}

/// # Safety
/// The context is current, and the program is one of its programs, and linked.
unsafe fn active_uniforms(
    glow: &glow::Context,
    program: glow::Program,
) -> HashMap<String, Uniform> {
    let mut uniforms = HashMap::new();
    // SAFETY: by this function's contract; indices stay below the program's count.
    unsafe {
        for index in 0..glow.get_active_uniforms(program) {
            let Some(active) = glow.get_active_uniform(program, index) else {
                continue;
            };
            if let Some(location) = glow.get_uniform_location(program, &active.name) {
                let name = active.name.trim_end_matches("[0]").to_owned();
                uniforms.insert(
                    name,
                    Uniform {
                        location,
                        kind: active.utype,
                    },
                );
            }
        }
    }
    uniforms
}

/// All words of the statements with `uniform`: the names of all uniforms, among others.
fn declared_uniforms(body: &str) -> BTreeSet<String> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    body.split(';')
        .filter_map(|statement| statement.split_once("uniform "))
        .flat_map(|(_, rest)| rest.split(|c| !is_word(c)))
        .filter(|word| !word.is_empty())
        .map(str::to_owned)
        .collect()
}

/// The first line number in a driver's log: Mesa writes `0:12(5)`, NVIDIA `0(12)`, others
/// `ERROR: 0:12:`.
fn error_line(log: &str) -> Option<u32> {
    let digits = |text: &str| -> Option<u32> {
        let end = text
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(text.len());
        text[..end].parse().ok()
    };
    let start = |text: &str| text.find("0:").into_iter().chain(text.find("0(")).min();
    log.lines()
        .find_map(|line| digits(&line[start(line)? + 2..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_is_found_in_the_log_of_every_driver() {
        assert_eq!(error_line("0:12(5): error: syntax error"), Some(12));
        assert_eq!(
            error_line("0(7) : error C1008: undefined variable"),
            Some(7)
        );
        assert_eq!(
            error_line("Compilation failed\nERROR: 0:3: 'x' : undeclared"),
            Some(3)
        );
        assert_eq!(error_line("no idea"), None);
    }

    #[test]
    fn uniforms_are_found_where_they_are_declared() {
        let names =
            declared_uniforms("uniform mat4 a;\nuniform vec3 b, c;\nin vec3 d;void main(){}");
        assert!(["a", "b", "c"].iter().all(|&name| names.contains(name)));
        assert!(!names.contains("d"));
    }
}
