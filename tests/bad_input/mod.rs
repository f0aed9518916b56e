//! Broken files: each gives one error that says where and why, or a smaller result, and none
//! stops the program.

mod broken;
mod everything;
mod original_crashes;
mod slow;
