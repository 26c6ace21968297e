let colours =
  {|
:root { color-scheme: light dark;
  --paper: #faf8f5; --card: #ffffff; --ink: #1c1820; --soft: #6a6372;
  --line: #e6e1e3; --front: #a8327d; --knee: #e0552b; --other: #857b93;
  --law: #5b4b9a; --band: #5b4b9a1a; --chosen: #fdeee4; --good: #1f7a5c;
  --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root {
  --paper: #100e14; --card: #18151d; --ink: #efeaf1; --soft: #a199aa;
  --line: #2d2833; --front: #e2659e; --knee: #fe9f6d; --other: #8d839b;
  --law: #a394f0; --band: #a394f01f; --chosen: #2e1f1d; --good: #6fcfa9;
  --bad: #ff8a80; } }
|}

let page =
  {|
* { box-sizing: border-box; }
body { margin: 0; overflow-wrap: anywhere; background: var(--paper); color: var(--ink);
  font: 16px/1.5 Inter, ui-sans-serif, system-ui, -apple-system, Segoe UI,
    Roboto, Noto Sans, Helvetica Neue, Arial, sans-serif;
  font-variant-numeric: tabular-nums; -webkit-text-size-adjust: 100%;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
main { max-width: 1128px; margin: 0 auto; padding: 48px 24px 64px; }
header { display: grid; grid-template-columns: 1fr minmax(0, 380px); gap: 48px;
  align-items: center; }
h1 { font-size: clamp(34px, 5.2vw, 60px); line-height: 1.04; margin: 8px 0 16px;
  letter-spacing: -0.035em; font-weight: 700; text-wrap: balance; }
h2 { font-size: 24px; line-height: 1.2; letter-spacing: -0.02em;
  margin: 64px 0 6px; }
p { margin: 0; max-width: 92ch; text-wrap: pretty; }
.eyebrow { color: var(--soft); }
.eyebrow b { color: var(--front); font-weight: 600; }
.lede { max-width: 40em; font-size: clamp(18px, 1.7vw, 21px); line-height: 1.45; }
.facts { color: var(--soft); font-size: 14px; margin-top: 14px; }
.note { color: var(--soft); font-size: 15px; margin-bottom: 18px; }
img { display: block; width: 100%; height: auto; image-rendering: pixelated;
  max-height: 640px; object-fit: contain; }
figure { margin: 0; }
.finest img { border-radius: 10px; box-shadow: 0 1px 2px #0003, 0 12px 40px #0003; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr));
  margin-top: 40px; border: 1px solid var(--line); border-radius: 12px;
  background: var(--card); overflow: hidden; }
.tile { padding: 16px 20px; display: flex; flex-direction: column;
  font-size: 14px; color: var(--soft); box-shadow: 1px 0 0 var(--line), 0 1px 0 var(--line); }
.tile strong { font-size: 30px; line-height: 1.2; color: var(--ink);
  letter-spacing: -0.02em; white-space: nowrap; }
.tile .goal { color: var(--law); font-weight: 600; }
footer { margin-top: 72px; padding-top: 16px; border-top: 1px solid var(--line);
  color: var(--soft); font-size: 13px; }
.chip { display: inline-block; padding: 0 9px; border-radius: 99px;
  font-size: 12.5px; line-height: 20px; font-weight: 600; white-space: nowrap;
  border: 1px solid currentColor; }
.chip.knee { background: var(--knee); border-color: var(--knee);
  color: var(--paper); margin-left: 8px; }
.chip.plain { color: var(--soft); border-color: transparent; padding: 0;
  font-weight: 400; }
.chip.saves { color: var(--good); }
.chip.waste { color: var(--knee); }
.chip.wrong { color: var(--bad); }
|}

let plot =
  {|
.figure { background: var(--card); border: 1px solid var(--line);
  border-radius: 12px; padding: 20px 16px 12px 20px; }
.plot { display: block; width: 100%; height: auto; overflow: visible; }
.plot.narrow { display: none; }
.plot text { font-size: 13px; fill: var(--ink); }
.plot .tick, .plot .axis { fill: var(--soft); font-size: 12.5px; }
.plot .grid { stroke: var(--line); }
.plot .band { fill: var(--band); }
.plot .law { stroke: var(--law); stroke-width: 1.6; stroke-dasharray: 7 6; fill: none; }
.plot .target { stroke: var(--law); stroke-opacity: .35; }
.plot .range { stroke: var(--law); stroke-width: 7; stroke-opacity: .3;
  stroke-linecap: round; }
.plot .goal { fill: var(--law); }
.plot .price { fill: var(--law); font-weight: 600; }
.plot .front { stroke: var(--front); stroke-width: 2.5; fill: none;
  stroke-linejoin: round; }
.plot .sample { fill: var(--front); stroke: var(--card); stroke-width: 1.5; }
.plot .other { fill: var(--card); stroke: var(--other); stroke-width: 1.5; }
.plot .knee { fill: none; stroke: var(--knee); stroke-width: 3; }
.plot .best, .plot .rung, .plot .key { paint-order: stroke; stroke: var(--card);
  stroke-width: 3.5; stroke-linejoin: round; }
.plot .best { fill: var(--knee); font-weight: 700; font-size: 14px; }
.plot .rung { fill: var(--front); font-weight: 600; }
.plot .key { fill: var(--soft); font-size: 12px; }
.swatches { display: flex; flex-wrap: wrap; gap: 6px 22px; margin-top: 12px;
  font-size: 14px; color: var(--soft); }
.swatch i { display: inline-block; width: 22px; margin-right: 8px;
  vertical-align: middle; border-top: 2.5px solid var(--front); }
.swatch i.sample, .swatch i.other, .swatch i.knee { width: 11px; height: 11px;
  border-radius: 50%; border: 0; background: var(--front); }
.swatch i.other { background: none; border: 1.5px solid var(--other); }
.swatch i.knee { width: 14px; height: 14px; background: none; border: 3px solid var(--knee); }
.swatch i.range { border-top: 7px solid var(--law); opacity: .35; border-radius: 4px; }
.swatch i.law { border-top: 2px dashed var(--law); }
.swatch sup { line-height: 0; }
|}

let table =
  {|
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 15px; }
th, td { padding: 7px 14px; border-bottom: 1px solid var(--line);
  text-align: left; white-space: nowrap; font-weight: 400; }
th[scope=col] { color: var(--soft); font-size: 13px; border-bottom-color: var(--soft); }
th:first-child, td:first-child { padding-left: 6px; }
.n { text-align: right; }
td.says, th.says { text-align: right; }
.narrow-only { display: none; }
.key { display: inline-block; width: 22px; color: var(--soft); font-size: 13px; }
.pareto { color: var(--front); }
.chosen th, .chosen td { background: var(--chosen); }
.changes tr:first-child th { padding-top: 30px; }
.changes .key { color: var(--other); font-weight: 600; }
|}

let bars =
  {|
ul { list-style: none; margin: 0; padding: 0; }
.shares li { display: grid; gap: 4px 14px; align-items: center;
  grid-template-columns: minmax(120px, 220px) 1fr 56px 1fr 64px;
  padding: 7px 6px; border-bottom: 1px solid var(--line); }
.shares .head { color: var(--soft); font-size: 13px; align-items: end;
  border-bottom-color: var(--soft); }
.shares .what { }
.kind { color: var(--soft); font-size: 13px; margin-left: 8px; }
.track { height: 14px; border-radius: 3px; background: var(--line); overflow: hidden; }
.track i { display: block; height: 100%; border-radius: 3px; }
.track .time { background: var(--knee); }
.track .loss { background: var(--law); }
.amount { text-align: right; font-size: 15px; white-space: nowrap; }
.head .marks { margin-top: 4px; }
.cards { display: grid; gap: 12px; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr));
  margin-top: 12px; }
.cards .waste, .cards .saves { background: var(--card); border: 1px solid var(--line);
  border-left: 4px solid var(--knee); border-radius: 8px; padding: 12px 16px; }
.cards .saves { border-left-color: var(--good); }
.cards .amount { color: var(--soft); margin-left: 10px; }
.cards ul li { font-size: 14px; color: var(--soft); }
code { font: 13px/1.5 ui-monospace, SFMono-Regular, Menlo, Consolas, DejaVu Sans Mono, monospace;
  color: var(--ink); }
|}

let pictures =
  {|
.scale { max-width: 520px; margin: 0 0 22px; }
.scale p { color: var(--soft); font-size: 14px; margin-bottom: 6px; }
.legend { padding: 0 12px; }
.legend img { height: 12px; border-radius: 3px; image-rendering: auto; object-fit: fill; }
.marks { position: relative; height: 22px; font-size: 13px; color: var(--soft); }
.marks span { position: absolute; transform: translateX(-50%); white-space: nowrap; }
.rungs { display: grid; gap: 20px;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 340px), 1fr)); }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 2px; border-radius: 8px;
  overflow: hidden; }
.rung.chosen .pair { outline: 3px solid var(--knee); outline-offset: 2px; }
figcaption { font-size: 14px; color: var(--soft); margin-top: 8px; }
figcaption strong { color: var(--ink); }
.maps { display: grid; gap: 32px; margin-top: 14px;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 340px), 1fr)); }
.map img { border-radius: 8px; }
.pair, .map img { box-shadow: 0 0 0 1px var(--line); }
.map .legend { margin-top: 12px; padding: 0 24px; }
.map .legend img { border-radius: 3px; }
|}

let media =
  {|
@media (max-width: 720px) {
  main { padding: 24px 16px 40px; }
  header { grid-template-columns: 1fr; gap: 24px; }
  h2 { margin-top: 48px; }
  .tiles { grid-template-columns: 1fr 1fr; margin-top: 28px; }
  .figure { padding: 12px 8px 8px 10px; }
  .plot.wide { display: none; }
  .plot.narrow { display: block; }
  table { font-size: 14px; }
  th, td { padding: 6px 8px; }
  .extra, .says { display: none; }
  .narrow-only { display: block; text-indent: 0; }
  th[scope=row] { white-space: normal; text-indent: -22px; }
  th[scope=row]:first-child { padding-left: 28px; }
  .key, .chip { text-indent: 0; }
  .shares li { grid-template-columns: 1fr 60px; }
  .shares .what { grid-column: span 2; }
}
@media print {
  :root { --paper: #fff; --card: #fff; --ink: #000; --soft: #555; --line: #ddd;
    --front: #a8327d; --knee: #d24a20; --law: #5b4b9a; --band: #5b4b9a1a;
    --chosen: #fdeee4; --other: #857b93; --good: #1f7a5c; --bad: #b3261e;
    color-scheme: light; }
  main { max-width: none; padding: 0; }
  h2 { break-after: avoid; margin-top: 32px; }
  figure, tr, .figure, .tiles, .shares li, .cards li { break-inside: avoid; }
  .scroll { overflow: visible; }
}
|}

let css = String.concat "" [ colours; page; plot; table; bars; pictures; media ]
