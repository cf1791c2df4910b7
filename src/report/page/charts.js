// Draws the charts of the page, from the data in #report-data, with Chart.js.
"use strict";
const reportData = JSON.parse(document.getElementById("report-data").textContent);
const reportCharts = {};

(() => {
  // The palette of Okabe and Ito without its yellow; without colour, dashes and markers tell curves apart.
  const palette = ["#000000", "#D55E00", "#0072B2", "#E69F00", "#009E73", "#56B4E9", "#CC79A7"];
  const dashes = { line: [[], [14, 4], [14, 4, 2, 4], [3, 3]], dashed: [[6, 5], [2, 4], [10, 4, 2, 4], [1, 3]] };
  const shapes = ["circle", "rect", "triangle", "rectRot", "crossRot", "star"];

  const point = (p) => (p === null ? { x: NaN, y: NaN } : { x: p[0], y: p[1] });

  function dataset(curve, index, place) {
    const colour = palette[index % palette.length];
    const data = { label: curve.label, data: curve.points.map(point), borderColor: colour, spanGaps: false };
    if (curve.style === "markers") {
      const many = curve.points.length > 60, few = curve.points.length < 4;
      return { ...data, showLine: false, pointStyle: shapes[place % shapes.length], pointRadius: many ? 3 : few ? 7 : 5,
               pointBorderWidth: 1.5, pointBackgroundColor: many ? "transparent" : few ? colour : "#ffffff", pointHitRadius: 8 };
    }
    if (curve.style === "area")
      return { ...data, showLine: true, pointRadius: 0, borderWidth: 0, fill: "shape", backgroundColor: "#00000022" };
    return { ...data, showLine: true, pointRadius: 0, pointHitRadius: 6, borderWidth: 2, pointStyle: "line",
             borderDash: dashes[curve.style][place % dashes[curve.style].length] };
  }

  function scale(title, logarithmic) {
    return { type: logarithmic ? "logarithmic" : "linear", title: { display: true, text: title, color: "#161616" },
             grid: { color: "#dddddd" }, ticks: { color: "#161616", maxRotation: 0, autoSkipPadding: 16 } };
  }

  function draw(id, spec) {
    const places = {};
    const datasets = spec.curves.map((curve, index) => {
      places[curve.style] = (places[curve.style] ?? -1) + 1;
      return dataset(curve, index, places[curve.style]);
    });
    addLegend(id, datasets);
    reportCharts[id] = new Chart(document.getElementById("chart-" + id), {
      type: "scatter",
      data: { datasets },
      options: {
        animation: false, responsive: true, maintainAspectRatio: false, normalized: true,
        devicePixelRatio: Math.max(2, window.devicePixelRatio || 1),
        interaction: { mode: "nearest", intersect: false },
        scales: { x: scale(spec.x, spec.logX), y: scale(spec.y, spec.logY) },
        plugins: {
          title: { display: true, text: spec.title, color: "#161616", font: { size: 15 } },
          legend: { display: false },
        },
      },
    });
  }

  // ---- the legend, as the curves are drawn

  const marks = {
    circle: "M27 7a5 5 0 1 1-10 0a5 5 0 1 1 10 0", rect: "M17 2h10v10h-10z", triangle: "M22 2l5.5 9.5h-11z",
    rectRot: "M22 1l6 6l-6 6l-6-6z", crossRot: "M17.5 2.5l9 9m-9 0l9-9", star: "M17.5 2.5l9 9m-9 0l9-9M22 1v12M16 7h12",
  };

  function symbolOf(data) {
    if (data.fill === "shape") return `<path d="M2 2h40v10h-40z" fill="#000" fill-opacity=".15"/>`;
    const path = data.showLine ? "M1 7h42" : marks[data.pointStyle];
    const dashes = data.showLine ? ` stroke-dasharray="${data.borderDash.join(" ")}"` : "";
    return `<path d="${path}" fill="none" stroke="${data.borderColor}" stroke-width="${data.showLine ? 2.2 : 1.6}"${dashes}/>`;
  }

  function addLegend(id, datasets) {
    const list = document.createElement("ul");
    list.className = "legend";
    for (const data of datasets) {
      if (data.label === "") continue;
      const item = document.createElement("li");
      item.innerHTML = `<svg width="44" height="14" aria-hidden="true">${symbolOf(data)}</svg>`;
      item.append(document.createTextNode(data.label));
      list.append(item);
    }
    document.getElementById("chart-" + id).closest(".plot").after(list);
  }

  // The same numbers as a table, for those who cannot see the chart or want to copy it; made when opened.
  function fillNumbers(details) {
    if (details.querySelector("table")) return;
    const spec = reportData.charts[details.dataset.chart];
    const table = document.createElement("table");
    const addRow = (cells, tag) => {
      const row = table.insertRow();
      for (const text of cells) {
        const cell = document.createElement(tag);
        cell.textContent = text;
        row.append(cell);
      }
    };
    addRow(["curve", spec.x, spec.y], "th");
    for (const curve of spec.curves)
      for (const p of curve.points) if (p !== null) addRow([curve.label, p[0], p[1]], "td");
    const box = document.createElement("div");
    box.tabIndex = 0;
    box.append(table);
    details.append(box);
  }

  for (const [id, spec] of Object.entries(reportData.charts)) draw(id, spec);
  for (const details of document.querySelectorAll("details.numbers"))
    details.addEventListener("toggle", () => fillNumbers(details));
  const fit = () => { for (const chart of Object.values(reportCharts)) chart.resize(); };
  window.addEventListener("beforeprint", fit);
  window.addEventListener("afterprint", fit);
})();
