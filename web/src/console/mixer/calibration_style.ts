import { css } from "lit";

/** A head with what is asked, the bars below it, what can be set at its foot. */
export const calibrationStyle = css`
  section {
    width: min(860px, 100%);
    grid-template-rows: auto auto auto auto minmax(80px, 1fr) auto auto auto;
    overflow: hidden;
  }
  h2 {
    margin: 0;
    flex: 1;
    overflow-wrap: anywhere;
  }
  .asks {
    color: var(--text);
    font-size: 18px;
    min-height: 44px;
    flex: 1 1 260px;
  }
  .unrest {
    color: var(--hand);
  }
  .now {
    border: 1px solid var(--line);
    border-radius: 6px;
    padding: 10px 12px;
  }
  .now button {
    min-height: 44px;
    min-width: 120px;
  }
  .main {
    border-color: var(--hand);
    color: var(--hand);
  }
  ol {
    display: flex;
    flex-wrap: wrap;
    gap: 4px;
  }
  ol button {
    min-height: 30px;
    padding: 0 8px;
    font-size: 12px;
  }
  ol button.known::after {
    content: " \\2713";
  }
  .bars {
    overflow: auto;
    scrollbar-width: thin;
  }
  .key {
    font-size: 12px;
  }
  .tuning {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(min(300px, 100%), 1fr));
    gap: 6px 16px;
    align-items: start;
  }
  @media (max-width: 700px) {
    section {
      display: flex;
      flex-direction: column;
      overflow: auto;
    }
    .bars {
      flex: none;
      max-height: 34vh;
    }
  }
  @media (pointer: coarse) {
    button,
    ol button {
      min-height: 44px;
    }
  }
`;
