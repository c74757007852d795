/** What the studio says about what is delivered; the same values as web_studio/deliver.py. */

export interface BoardLayout {
  panels: number;
  paper: string;
  orientation: string;
}

type Box = [number, number, number, number];

export interface BoardPage {
  width: number;
  height: number;
  cells: { picture: Box; words: Box; size: number }[];
}

export interface Deliverable {
  what: string;
  title: string;
  words: string;
  files: { name: string; bytes: number; written: string }[];
  state: "fresh" | "old" | "none" | "saved";
  write: string;
}

export interface Deliveries {
  layout: BoardLayout;
  page: BoardPage;
  items: Deliverable[];
}
