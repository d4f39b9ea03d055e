// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The style sheet of report pages: screens wide and narrow, light and dark, and paper.
#pragma once

namespace ellipsoid::post {

inline constexpr const char* html_style = R"css(
:root { color-scheme: light dark; --ink: #22262b; --ground: #fff; --soft: #f2f4f7; --line: #d8dbe0;
  --faint: #555c64; --link: #0b57a4; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e3e6ea; --ground: #16191d; --soft: #242a31; --line: #3d454e; --faint: #a9b1ba;
    --link: #7db7f0; }
  img { filter: brightness(.86); }
}
* { box-sizing: border-box; }
body { font: 16px/1.5 sans-serif; max-width: 80rem; margin: 2rem auto; padding: 0 1rem;
  color: var(--ink); background: var(--ground); overflow-wrap: anywhere; }
a { color: var(--link); }
nav ul { display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; list-style: none; padding: .6rem 0;
  margin: 0; border-block: 1px solid var(--line); }
.wide { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .85rem; overflow-wrap: normal; }
caption { text-align: left; font-weight: bold; padding: .3rem 0; }
th, td { border-bottom: 1px solid var(--line); padding: .3rem .7rem; text-align: right; }
td { white-space: nowrap; }
th { font-weight: normal; }
thead th { background: var(--soft); font-weight: bold; vertical-align: bottom; }
th:first-child { text-align: left; position: sticky; left: 0; background: var(--ground); }
thead th:first-child { background: var(--soft); }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 24rem), 1fr));
  gap: 1rem; }
figure { margin: 1rem 0; }
.pictures figure { margin: 0; }
img { max-width: 100%; height: auto; border: 1px solid var(--line); background: #fff; }
figcaption { color: var(--faint); font-size: .9rem; }
code { font-size: .9em; }
pre { white-space: pre-wrap; background: var(--soft); padding: .6rem; }
@media (max-width: 40rem) {
  body { margin: 1rem auto; }
  th, td { padding: .3rem .4rem; }
}
@page { size: A4 landscape; margin: 12mm; }
@media print {
  body { max-width: none; margin: 0; padding: 0; font-size: 10pt; }
  .wide { overflow: visible; }
  table { font-size: 7.5pt; max-width: 100%; }
  th, td { padding: .6mm 1.2mm; white-space: normal; overflow-wrap: anywhere; }
  th:first-child { position: static; }
  tr, figure { break-inside: avoid; }
  h2, caption { break-after: avoid; }
  .pictures { grid-template-columns: repeat(3, 1fr); }
  figure > img { max-height: 150mm; }
}
)css";

} // namespace ellipsoid::post
