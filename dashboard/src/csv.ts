/** The rows of a table of comma-separated values, by the names of its columns. */
export function readCsv(text: string): Record<string, string>[] {
  const rows: string[][] = [[]];
  let [cell, isQuoted] = ["", false];
  const end = () => {
    // What a spreadsheet would compute has an apostrophe in front.
    rows.at(-1)!.push(/^'[=+\-@\t\r\n]/.test(cell) ? cell.slice(1) : cell);
    cell = "";
  };
  for (let k = 0; k < text.length; k++) {
    const c = text[k]!;
    if (isQuoted) {
      if (c !== '"') cell += c;
      else if (text[k + 1] === '"') cell += text[++k]!;
      else isQuoted = false;
    } else if (c === '"') isQuoted = true;
    else if (c === ",") end();
    else if (c === "\n") {
      end();
      rows.push([]);
    } else if (c !== "\r") cell += c;
  }
  if (cell !== "" || rows.at(-1)!.length > 0) end();
  const [header = [], ...body] = rows;
  return body.filter((row) => row.length > 0).map((row) => Object.fromEntries(header.map((name, k) => [name, row[k] ?? ""])));
}
