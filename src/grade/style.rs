//! The style of the page: light or dark as the reader's system is, and fit for paper.

pub(super) const STYLE: &str = r#":root {
  color-scheme: light dark;
  --paper: #fbfbf9; --card: #ffffff; --ink: #1d2126; --dim: #5c6570; --line: #dcdfe3;
  --link: #1f5fa8; --right: #1c7a45; --right-soft: #e0f1e6; --wrong: #9a3d0e; --wrong-soft: #fbe8da;
  --none: #4b5563; --none-soft: #e8eaed; --bar: #7a94b3;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16191d; --card: #1e2227; --ink: #e6e8ea; --dim: #a0a8b2; --line: #343a42;
    --link: #86b7ef; --right: #8bd7a8; --right-soft: #173423; --wrong: #f3b58c; --wrong-soft: #43260f;
    --none: #c3c9d1; --none-soft: #2c3138; --bar: #5f7fa6;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 88rem; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif;
}
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.15rem; margin: 2.4rem 0 .7rem; }
h3 { font-size: 1rem; margin: 0; }
p { margin: .3rem 0; }
a { color: var(--link); }
.dim { color: var(--dim); }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.wide { overflow-x: auto; border: 1px solid var(--line); border-radius: 8px; background: var(--card); }
table { border-collapse: collapse; width: 100%; }
th, td { padding: .45rem .75rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
th { font-weight: 600; font-size: .85rem; color: var(--dim); white-space: nowrap; }
th.number { text-align: right; }
tbody tr:last-child td { border-bottom: 0; }
code { font: .92em ui-monospace, "SF Mono", Menlo, Consolas, monospace; }
.class th.number { white-space: normal; }
.class th .dim { white-space: nowrap; }
.class .name { min-width: 9rem; overflow-wrap: anywhere; }
.class .result { min-width: 18rem; }
.bar { display: block; height: .5rem; margin-top: .45rem; border-radius: 2px; background: var(--bar); }
.of { display: block; width: 9rem; border-radius: 2px; background: var(--none-soft); margin-top: .45rem; }
.of .bar { margin: 0; }
.chip {
  display: inline-block; padding: .05rem .5rem; margin: 0 .25rem .2rem 0; border-radius: 4px;
  font-size: .85rem; background: var(--none-soft); color: var(--none);
}
.chip.right { background: var(--right-soft); color: var(--right); }
.chip.wrong { background: var(--wrong-soft); color: var(--wrong); }
.tests { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; width: 194px; }
img { display: block; max-width: 192px; height: auto; border: 1px solid var(--line); border-radius: 6px; background: #f7f7f4; }
figcaption { margin-top: .3rem; font-size: .9rem; }
.legend { display: flex; flex-wrap: wrap; gap: .4rem 1.2rem; font-size: .85rem; color: var(--dim); margin: .8rem 0 0; }
.legend i { display: inline-block; width: 1rem; height: .7rem; margin-right: .35rem; border-radius: 2px; }
.legend i.ramp { width: 6rem; }
details { border: 1px solid var(--line); border-radius: 8px; background: var(--card); margin: .5rem 0; }
summary { display: flex; flex-wrap: wrap; gap: .3rem 1rem; align-items: baseline; padding: .6rem .9rem; cursor: pointer; }
summary::before { content: "▸"; color: var(--dim); }
details[open] > summary::before { content: "▾"; }
.note { padding: 0 .9rem; }
.why { font-size: .9rem; }
summary h3 { min-width: 9rem; overflow-wrap: anywhere; }
summary .number { min-width: 5rem; }
.test { display: flex; gap: 1rem; padding: .9rem; border-top: 1px solid var(--line); }
.test > div { min-width: 0; flex: 1; }
.test h4 { margin: 0 0 .3rem; font-size: .95rem; }
.test .chip { font-weight: 400; margin-left: .35rem; }
.results { scroll-margin-top: 3.2rem; }
pre {
  margin: .5rem 0 0; font: .86rem/1.45 ui-monospace, "SF Mono", Menlo, Consolas, monospace;
  white-space: pre-wrap; overflow-wrap: anywhere;
}
pre span { display: block; }
pre .told { padding-left: 11ch; text-indent: -11ch; }
footer { margin-top: 3rem; font-size: .85rem; color: var(--dim); }
@media (max-width: 40rem) { .test { flex-direction: column; } body { padding: 1rem .75rem 3rem; } }
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  details::details-content { content-visibility: visible; block-size: auto; }
  .wide { overflow: visible; border: 0; }
  .wide td, .wide th { padding: .3rem .5rem; overflow-wrap: anywhere; }
  h2, h3, summary { break-after: avoid; }
  figure, .test, tr, .legend { break-inside: avoid; }
}
"#;
