//! 3.1 The matrix stack.

use editor_core::math::MatrixStack;
use glam::{Mat4, Vec3};

fn turn() -> Mat4 {
    Mat4::from_rotation_z(0.7)
}

fn shift() -> Mat4 {
    Mat4::from_translation(Vec3::new(1.0, 2.0, 3.0))
}

#[test]
fn an_empty_stack_returns_the_identity() {
    assert_eq!(MatrixStack::new().top(), Mat4::IDENTITY);
}

#[test]
fn push_multiplies_the_current_top_from_the_right() {
    let mut stack = MatrixStack::new();
    stack.push(turn());
    stack.push(shift());
    assert_eq!(stack.top(), turn() * shift());
    assert!(!stack.top().abs_diff_eq(shift() * turn(), 1e-3));
}

#[test]
fn pop_brings_back_the_top_before_the_push() {
    let mut stack = MatrixStack::new();
    stack.push(turn());
    stack.push(shift());
    stack.pop();
    assert_eq!(stack.top(), turn());
    stack.pop();
    assert_eq!(stack.top(), Mat4::IDENTITY);
}

#[test]
fn pop_on_an_empty_stack_does_nothing() {
    let mut stack = MatrixStack::new();
    stack.pop();
    stack.push(turn());
    assert_eq!(stack.top(), turn());
}

#[test]
fn clear_empties_the_stack() {
    let mut stack = MatrixStack::new();
    stack.push(turn());
    stack.push(shift());
    stack.clear();
    assert_eq!(stack.top(), Mat4::IDENTITY);
}
