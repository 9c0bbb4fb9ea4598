import { css } from "lit";
import { ellipsis } from "../../ui/theme";

export const style = css`
  :host {
    padding: 8px;
  }
  section {
    display: grid;
    grid-template: "head head" auto "views side" minmax(0, 1fr) / minmax(0, 1fr) 312px;
    gap: 8px;
    width: 100%;
    height: 100%;
    padding: 10px;
    overflow: hidden;
  }
  section > header {
    grid-area: head;
  }
  header {
    display: flex;
    align-items: baseline;
    gap: 10px;
    min-width: 0;
  }
  header b {
    ${ellipsis}
  }
  .views {
    grid-area: views;
    position: relative;
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    gap: 6px;
    min-height: 0;
  }
  omote-scan-views,
  omote-photograph {
    border: 1px solid var(--line);
    border-radius: 5px;
  }
  .side {
    grid-area: side;
    display: grid;
    align-content: start;
    gap: 9px;
    min-height: 0;
    overflow: hidden auto;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
    padding: 0 2px;
  }
  .waiting {
    grid-area: views / views / side / side;
    display: grid;
    place-content: center;
    justify-items: center;
    gap: 12px;
    text-align: center;
  }
  omote-turn {
    grid-area: views / views / side / side;
  }
  .waiting progress {
    width: min(420px, 70vw);
    height: 8px;
  }
  .over {
    grid-area: 1 / 1 / -1 / -1;
    position: absolute;
    inset: 0;
    z-index: 1;
    background: #08090ac0;
  }
  .verdict {
    padding: 8px 10px;
    border: 1px solid var(--coming);
    border-radius: 5px;
    display: grid;
    gap: 5px;
    user-select: text;
  }
  .verdict.unsure {
    border-color: var(--attention);
  }
  .verdict p {
    color: var(--text);
  }
  .verdict ul {
    padding-left: 16px;
    list-style: disc;
    color: var(--attention);
  }
  .asked {
    border-color: var(--attention);
  }
  .failed {
    color: var(--attention);
  }
  .show input[type="range"] {
    flex: 1;
  }
  .legend {
    display: grid;
    gap: 2px;
    color: var(--dim);
    font-size: 11.5px;
  }
  .legend div {
    height: 8px;
    border-radius: 4px;
  }
  .legend p {
    display: flex;
    justify-content: space-between;
    max-width: none;
  }
  .points {
    display: grid;
    grid-template-columns: 76px minmax(0, 1fr);
    gap: 8px;
    align-items: start;
  }
  .face {
    width: 76px;
    fill: none;
    stroke: var(--edge);
    stroke-width: 1.6;
  }
  .face circle {
    fill: var(--faint);
    stroke: none;
  }
  .face circle.given {
    fill: var(--hand);
  }
  .face circle.chosen {
    fill: var(--coming);
    stroke: #04140a;
  }
  ol {
    display: grid;
    gap: 2px;
  }
  li {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 2px;
  }
  li button {
    text-align: left;
    min-height: 24px;
    ${ellipsis}
  }
  li button[aria-pressed="true"] {
    color: var(--text);
    border-color: var(--coming);
  }
  .taking {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    align-items: center;
    gap: 6px 8px;
  }
  .called {
    grid-column: 2;
  }
  input[type="color"] {
    width: 40px;
    height: 30px;
    padding: 1px;
    background: none;
    border: 1px solid var(--line);
    border-radius: 4px;
  }
  .acts {
    position: sticky;
    bottom: 0;
    display: flex;
    flex-wrap: wrap;
    gap: 6px;
    padding: 8px 0 2px;
    background: var(--panel);
  }
  .acts p {
    flex: 1 0 100%;
  }
  .acts button {
    flex: 1;
  }
  @media (pointer: coarse) {
    li button {
      min-height: 36px;
    }
  }
  @media (max-width: 940px) {
    section {
      grid-template: "head" auto "views" minmax(0, 1.15fr) "side" minmax(0, 1fr) / minmax(0, 1fr);
    }
  }
`;
