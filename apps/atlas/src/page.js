// The comparison is sorted by the heading that is pressed; pressed again, the other way round.
for (const heading of document.querySelectorAll("thead tr:last-child th")) {
  const button = document.createElement("button");
  button.type = "button";
  button.append(...heading.childNodes);
  heading.append(button);
  button.addEventListener("click", () => {
    const falling = heading.getAttribute("aria-sort") === "ascending";
    const column = heading.cellIndex;
    const body = heading.closest("table").tBodies[0];
    const key = (row) => row.cells[column].dataset.value ?? row.cells[column].textContent;
    const order = (a, b) => Number(key(a)) - Number(key(b)) || key(a).localeCompare(key(b));
    const rows = [...body.rows].sort((a, b) => (falling ? order(b, a) : order(a, b)));
    body.append(...rows);
    for (const other of heading.parentElement.cells) other.setAttribute("aria-sort", "none");
    heading.setAttribute("aria-sort", falling ? "descending" : "ascending");
  });
}
