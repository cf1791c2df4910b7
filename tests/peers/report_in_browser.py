#!/usr/bin/env python3
"""Opens reports in a real browser (Debian's Chromium, without a window) and looks at them as a reader would.

    report_in_browser.py RUNOUT CASE [KEEP]

Runs CASE with the program RUNOUT, makes its pages and checks: nothing goes to the console, nothing is loaded from
elsewhere, charts have ink, the animation plays and can be scrubbed by key, the numbers are those of the database, a
name with a tag in it is text, and nothing is cut off on A4. KEEP: a folder for the pictures and the pages.
"""

import base64
import json
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

NAME = "<script>window.broken = true</script> & slope \"7\""
A4_PIXELS = 688  # 182 mm, what the margins leave, at 96 pixels an inch
failures = []


def check(holds, sentence):
    print(("ok      " if holds else "FAILED  ") + sentence, flush=True)
    if not holds:
        failures.append(sentence)


def run(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def browser(profile):
    options = Options()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
                     "--window-size=1100,1400", "--user-data-dir=" + profile):
        options.add_argument(argument)
    options.binary_location = shutil.which("chromium")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def open_page(driver, path):
    driver.get("file://" + os.path.abspath(path))
    time.sleep(0.3)


def check_console(driver, page):
    # The readback that the browser warns of is that of check_charts, not of the page.
    entries = [entry for entry in driver.get_log("browser") if "willReadFrequently" not in entry["message"]]
    check(not entries, f"{page}: nothing on the console {entries if entries else ''}")
    loaded = driver.execute_script("return performance.getEntriesByType('resource').map((entry) => entry.name)")
    check(all(name.startswith("data:") for name in loaded), f"{page}: nothing is loaded from elsewhere {loaded}")


def check_charts(driver, page, wanted):
    ink = driver.execute_script("""
        const inked = {};
        for (const [id, chart] of Object.entries(reportCharts)) {
          const canvas = chart.canvas, box = chart.chartArea;
          const ratio = canvas.width / chart.width;
          const pixels = canvas.getContext("2d").getImageData(box.left * ratio, box.top * ratio,
              (box.right - box.left) * ratio, (box.bottom - box.top) * ratio).data;
          let dark = 0;
          for (let i = 0; i < pixels.length; i += 4)
            if (pixels[i + 3] > 128 && pixels[i] + pixels[i + 1] + pixels[i + 2] < 540) ++dark;
          inked[id] = dark;
        }
        return inked;""")
    for chart in wanted:
        check(ink.get(chart, 0) > 100, f"{page}: chart {chart} has ink ({ink.get(chart, 0)} dark pixels)")
    check(set(wanted) == set(ink), f"{page}: charts are {sorted(ink)}")


def particles_drawn(driver):
    """A number that changes when the picture of the particles does."""
    return driver.execute_script("""
        const stage = document.getElementById("stage");
        const pixels = stage.getContext("2d").getImageData(0, 0, stage.width, stage.height).data;
        let sum = 0;
        for (let i = 0; i < pixels.length; i += 4) sum = (sum * 31 + pixels[i] * 7 + pixels[i + 2]) % 1000000007;
        return sum;""")


def check_animation(driver):
    start = particles_drawn(driver)
    button = driver.find_element(By.ID, "animation-play")
    button.click()
    time.sleep(0.8)
    check(driver.execute_script("return runAnimation.now() > runAnimation.start"), "animation: time goes on")
    check(particles_drawn(driver) != start, "animation: the picture moves")
    button.click()
    held = driver.execute_script("return runAnimation.now()")
    time.sleep(0.2)
    check(driver.execute_script("return runAnimation.now()") == held, "animation: pauses")
    slider = driver.find_element(By.ID, "animation-time")
    slider.send_keys(Keys.END)
    check(driver.execute_script("return runAnimation.now() === runAnimation.end"), "animation: End goes to the end")
    slider.send_keys(Keys.HOME)
    check(particles_drawn(driver) == start, "animation: Home goes to the start")
    slider.send_keys(Keys.END)
    shown = set()
    for field in ("speed", "pressure", "layer"):
        Select(driver.find_element(By.ID, "animation-field")).select_by_value(field)
        shown.add(particles_drawn(driver))
    check(len(shown) == 3, "animation: colours tell speed, pressure and layer apart")
    button.send_keys(Keys.SPACE)
    check(driver.execute_script("return runAnimation.playing()"), "animation: the space key plays")
    driver.execute_script("runAnimation.pause()")


def check_numbers(driver, database, run_id):
    connection = sqlite3.connect(database)
    connection.row_factory = sqlite3.Row
    row = connection.execute("SELECT * FROM measure WHERE run_id = ?", (run_id,)).fetchone()
    shown = driver.execute_script(
        "return [...document.querySelectorAll('#result td[data-value]')].map((cell) => [cell.dataset.value, cell.textContent])")
    stored = [row[key] for key in row.keys() if key != "run_id" and row[key] is not None]
    check(sorted(float(value) for value, _ in shown) == sorted(stored), "numbers: all measures, as the database has them")
    check(all(abs(float(text) - float(value)) <= 6e-4 * abs(float(value)) for value, text in shown),
          "numbers: what is read is what is stored")
    last = connection.execute("SELECT time_s, front_m FROM series WHERE run_id = ? ORDER BY row_index DESC", (run_id,)).fetchone()
    point = driver.execute_script("return reportData.charts.front.curves[0].points.at(-1)")
    check(abs(point[0] - last[0]) < 1e-4 * last[0] and abs(point[1] - last[1]) < 1e-4 * abs(last[1]),
          "numbers: the chart of the front ends where the series does")


def check_names(driver):
    check(driver.execute_script("return window.broken === undefined"), "names: a script in a name does not run")
    check(NAME in driver.find_element(By.TAG_NAME, "h1").text, "names: it shows as it was typed")


def check_numbers_of_charts(driver):
    details = driver.find_element(By.CSS_SELECTOR, "details[data-chart=front]")
    details.find_element(By.TAG_NAME, "summary").send_keys(Keys.ENTER)
    time.sleep(0.1)
    check(len(details.find_elements(By.TAG_NAME, "tr")) > 5, "charts: their numbers open by key as a table")


def check_print(driver, page, keep):
    """Nothing is wider than the paper, on the screen's side and on paper."""
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": A4_PIXELS, "height": 1000, "deviceScaleFactor": 1, "mobile": False})
    driver.execute_script("window.dispatchEvent(new Event('beforeprint'))")
    time.sleep(0.2)
    wide = driver.execute_script("""
        const wide = [];
        for (const element of document.querySelectorAll("body *")) {
          if (element.closest("caption, script, svg *")) continue;
          const box = element.getBoundingClientRect();
          if (box.width > 0 && box.right > window.innerWidth + 1) wide.push(element.tagName + "#" + element.id + " " + box.right);
        }
        return wide;""")
    check(not wide, f"{page}: nothing is cut off on A4 {wide[:5] if wide else ''}")
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    paper = driver.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True, "printBackground": True})
    data = base64.b64decode(paper["data"])
    check(data.startswith(b"%PDF") and len(data) > 20000, f"{page}: prints ({len(data) // 1000} kB)")
    if keep:
        with open(os.path.join(keep, page + ".pdf"), "wb") as file:
            file.write(data)


def picture(driver, keep, name):
    if not keep:
        return
    size = driver.execute_script("return [document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
    shot = driver.execute_cdp_cmd("Page.captureScreenshot", {
        "captureBeyondViewport": True, "clip": {"x": 0, "y": 0, "width": size[0], "height": size[1], "scale": 1}})
    with open(os.path.join(keep, name + ".png"), "wb") as file:
        file.write(base64.b64decode(shot["data"]))


def main():
    runout, case = sys.argv[1:3]
    keep = os.path.abspath(sys.argv[3]) if len(sys.argv) > 3 else None
    folder = tempfile.mkdtemp(prefix="runout-browser-")
    try:
        database = os.path.join(folder, "runs.db")
        for settings in (["--resolution", "12", "--name", NAME], ["--resolution", "10"], ["--resolution", "8"]):
            run(runout, "run", case, "--threads", "1", "--quiet", "--db", database, *settings)
        pages = {name: os.path.join(folder, name + ".html") for name in ("run", "section", "compare")}
        run(runout, "report", database, "--run", "1", "-o", pages["run"])
        run(runout, "report", database, "--section", "1", "-o", pages["section"])
        run(runout, "compare", database, "--run", "1", "--width", "20", "-o", pages["compare"])
        driver = browser(os.path.join(folder, "profile"))
        try:
            open_page(driver, pages["run"])
            check_charts(driver, "run", ["front", "speed", "energy", "deposit", "envelope-thickness", "envelope-speed",
                                        "envelope-flux", "travel-angle"])
            check_animation(driver)
            check_numbers(driver, database, 1)
            check_names(driver)
            check_numbers_of_charts(driver)
            picture(driver, keep, "run")
            check_print(driver, "run", keep)
            check_console(driver, "run")
            open_page(driver, pages["section"])
            check_charts(driver, "section", ["drop", "front-area", "exceed-run-out", "exceed-toe"])
            picture(driver, keep, "section")
            check_print(driver, "section", keep)
            check_console(driver, "section")
            open_page(driver, pages["compare"])
            check_charts(driver, "compare", ["travel-angle"])
            picture(driver, keep, "compare")
            check_print(driver, "compare", keep)
            check_console(driver, "compare")
        finally:
            driver.quit()
        if keep:
            for path in pages.values():
                shutil.copy(path, keep)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    print(json.dumps({"failed": failures}))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
