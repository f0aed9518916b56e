use serde::{Serialize, Serializer};
use std::fmt::Display;

/// A finding with its sentence.
#[derive(Serialize)]
struct Told<'a, F> {
    #[serde(flatten)]
    finding: &'a F,
    message: String,
}

/// Serializes findings with the sentence of each as `message`.
pub(super) fn with_messages<F: Serialize + Display, S: Serializer>(
    findings: &[F],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(findings.iter().map(|finding| Told {
        finding,
        message: finding.to_string(),
    }))
}
