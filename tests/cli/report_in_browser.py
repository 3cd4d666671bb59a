# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Opens the report of a results file in headless Chromium and looks at it as a reader would.

    report_in_browser.py --raygauge PROGRAM --results FILE.h5 [--screenshots FOLDER] [--most-seconds S]

Fails on an error on the console, a request to the network, a chart without its curves (by the pixels of their
colours), a control without effect, content wider than a phone, a download that lacks records, or a page of 10 MB or
more. The time to open is printed; it fails the test only with --most-seconds.
"""
import argparse
import base64
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select, WebDriverWait

MOST_BYTES = 10_000_000

# For each visible curve of a chart: how many pixels of the canvas nearly have its colour.
CURVE_PIXELS = """
const chart = raygauge.charts[arguments[0]], canvas = chart.canvas;
const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
return chart.data.datasets.map((dataset, index) => {
  if (!chart.isDatasetVisible(index)) return -1;
  const [r, g, b] = [1, 3, 5].map((i) => parseInt(dataset.borderColor.slice(i, i + 2), 16));
  let count = 0;
  const near = (i) => Math.abs(pixels[i] - r) + Math.abs(pixels[i + 1] - g) + Math.abs(pixels[i + 2] - b) < 24;
  for (let i = 0; i < pixels.length; i += 4) if (pixels[i + 3] > 128 && near(i)) count++;
  return count;
});
"""


class Failures(list):
    def expect(self, holds, message):
        if not holds:
            self.append(message)


def start_browser(profile):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--window-size=1280,900", "--disable-background-networking", f"--user-data-dir={profile}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def open_page(browser, page):
    """Seconds until everything is drawn."""
    start = time.monotonic()
    browser.get(page.as_uri())
    ready = "return document.documentElement.dataset.ready === 'true'"
    WebDriverWait(browser, 60).until(lambda b: b.execute_script(ready))
    return time.monotonic() - start


def check_silence(browser, page, failures):
    for entry in browser.get_log("browser"):
        if "Multiple readback operations" in entry["message"]:
            continue  # of CURVE_PIXELS above, not of the page
        failures.append(f"console: {entry['message']}")
    for entry in browser.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            url = message["params"]["request"]["url"]
            inside = url == page.as_uri() or url.startswith(("data:", "blob:", "chrome:"))
            failures.expect(inside, f"request to {url[:200]}")


def check_curves(browser, failures, when):
    """Every curve of every chart has left its colour on the canvas."""
    count = browser.execute_script("return raygauge.charts.length")
    failures.expect(count >= 4, f"{when}: only {count} charts")
    for chart in range(count):
        pixels = browser.execute_script(CURVE_PIXELS, chart)
        drawn = pixels and all(number < 0 or number > 40 for number in pixels)
        failures.expect(drawn, f"{when}: the curves of chart {chart} have {pixels} pixels")
    return count


def check_legend(browser, failures):
    """A click on the legend hides a curve and its pixels, another brings it back."""
    canvas = browser.find_elements(By.TAG_NAME, "canvas")[0]
    index = browser.execute_script("return raygauge.charts.findIndex((c) => c.canvas === arguments[0])", canvas)
    before = browser.execute_script(CURVE_PIXELS, index)
    place = browser.execute_script("""
        const chart = raygauge.charts[arguments[0]], box = chart.legend.legendHitBoxes[0];
        chart.canvas.scrollIntoView({block: "center"});
        return [box.left + box.width / 2 - chart.width / 2, box.top + box.height / 2 - chart.height / 2];""", index)
    def click():
        ActionChains(browser).move_to_element_with_offset(canvas, *map(int, place)).click().perform()
        time.sleep(0.7)  # two clicks in quick succession are a double click; and the curve is drawn by and by

    click()
    failures.expect(browser.execute_script(CURVE_PIXELS, index)[0] == -1, "the legend hides no curve")
    click()
    after = browser.execute_script(CURVE_PIXELS, index)
    failures.expect(after[0] > 0.8 * before[0], f"the legend does not bring the curve back: {before} {after}")


def check_controls(browser, failures):
    """Menus change what is shown, log/linear switches the axis, the theme the colours."""
    state = """return raygauge.charts.map((c) =>
        JSON.stringify([c.data.datasets.map((d) => d.data), c.options.scales.x.type]))"""
    for control, act in (("select", "menu"), ("button[data-axis=x]", "click")):
        block = browser.find_element(By.XPATH, "//div[@class='block'][.//canvas and .//select]")
        before = sorted(browser.execute_script(state))
        element = block.find_element(By.CSS_SELECTOR, control)
        if act == "menu":
            menu = Select(element)
            menu.select_by_index(len(menu.options) - 1)
        else:
            element.click()
        failures.expect(sorted(browser.execute_script(state)) != before, f"{control} has no effect")
    heat = "return [...document.querySelectorAll('.heat')].map((table) => table.textContent).join('|')"
    before = browser.execute_script(heat)
    menu = Select(browser.find_element(By.XPATH, "//section[@id='ratios']//select[@data-facet='method']"))
    menu.select_by_index(1)
    failures.expect(browser.execute_script(heat) != before, "the menu of the heat map has no effect")
    color = "return getComputedStyle(document.body).backgroundColor"
    light = browser.execute_script(color)
    browser.find_element(By.ID, "theme").click()
    failures.expect(browser.execute_script(color) != light, "the theme does not change")


def check_tables(browser, failures, when):
    """No table is wider than its box, with everything unfolded."""
    wide = browser.execute_script("""
        for (const fold of document.querySelectorAll("details")) fold.open = true;
        raygauge.fitTables();
        return [...document.querySelectorAll(".scroll")].filter((box) => box.scrollWidth > box.clientWidth + 1)
          .map((box) => box.textContent.slice(0, 40) + ": " + box.scrollWidth + " in " + box.clientWidth);""")
    failures.expect(not wide, f"{when}: tables wider than their boxes: {wide}")


def check_sorting(browser, failures):
    """A click on a head sorts by its column, another the other way round."""
    column = """
        const table = [...document.querySelectorAll("#summary table")].pop(), last = table.tHead.rows[0].cells.length - 1;
        table.tHead.rows[0].cells[last].click();
        return [...table.tBodies[0].rows].map((row) => Number(row.cells[last].textContent));"""
    up, down = browser.execute_script(column), browser.execute_script(column)
    failures.expect(up == sorted(up) and down == sorted(down, reverse=True), f"sorting gives {up} and {down}")


def check_axes(browser, failures):
    """The axes of every chart begin and end within a tenth of the data's range."""
    wrong = browser.execute_script("""
        return raygauge.charts.flatMap((chart, c) => ["x", "y"].filter((name) => {
          const axis = chart.scales[name], log = axis.type === "logarithmic";
          const all = chart.data.datasets.flatMap((set) => set.data).flatMap((p) => name === "x" ? [p.x] : [p.y, p.low, p.high])
            .filter((v) => v !== undefined && (!log || v > 0)).map((v) => log ? Math.log(v) : v);
          const low = Math.min(...all), high = Math.max(...all), ends = [axis.min, axis.max].map((v) => log ? Math.log(v) : v);
          return high > low && (low - ends[0] > 0.1 * (high - low) || ends[1] - high > 0.1 * (high - low));
        }).map((name) => c + name));""")
    failures.expect(not wrong, f"axes far beyond their data: {wrong}")


def check_phone(browser, failures):
    browser.set_window_size(500, 844)  # the narrowest window that Chromium grants
    phone = {"width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", phone)
    time.sleep(0.5)
    width = browser.execute_script("return [document.documentElement.scrollWidth, innerWidth]")
    failures.expect(width[0] <= width[1], f"content of {width[0]} pixels on a phone of {width[1]}")


def check_words(browser, failures, where):
    """No word of a table is broken, but for paths, hashes and the like, which are longer than any name."""
    broken = browser.execute_script("""
        const found = [];
        for (const table of document.querySelectorAll("table")) {
          const walker = document.createTreeWalker(table, NodeFilter.SHOW_TEXT);
          while (walker.nextNode()) {
            for (const word of walker.currentNode.data.matchAll(/[^\\s-]+/g)) {
              const range = document.createRange();
              range.setStart(walker.currentNode, word.index);
              range.setEnd(walker.currentNode, word.index + word[0].length);
              const lines = new Set([...range.getClientRects()].map((r) => Math.round(r.top)));
              if (word[0].length <= 24 && lines.size > 1) found.push(word[0]);
            }
          }
        }
        return found;""")
    failures.expect(not broken, f"words of tables broken on the {where}: {broken[:8]}")


def check_download(browser, failures, records):
    lines = browser.execute_async_script("""
        const done = arguments[arguments.length - 1];
        const block = raygauge.data.sections.flatMap((s) => s.blocks).find((b) => b.type === "records");
        const count = (text) => text.trimEnd().split("\\n").length;
        raygauge.unpack(block.gzip).then((text) => done(count(text)), (error) => done(String(error)));""")
    failures.expect(lines == records + 1, f"the download has {lines} lines for {records} records")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--results", required=True)
    parser.add_argument("--screenshots", type=pathlib.Path)
    parser.add_argument("--most-seconds", type=float)
    arguments = parser.parse_args()
    failures = Failures()
    with tempfile.TemporaryDirectory(prefix="raygauge-report-") as folder:
        page = pathlib.Path(folder) / "report.html"
        subprocess.run([arguments.raygauge, "report", arguments.results, "-o", str(page)], check=True,
                       stdout=subprocess.DEVNULL)
        information = json.loads(subprocess.check_output([arguments.raygauge, "info", arguments.results, "--json"]))
        browser = start_browser(folder + "/profile")
        try:
            seconds = open_page(browser, page)
            charts = check_curves(browser, failures, "light")
            shoot(browser, arguments.screenshots, "light")
            check_axes(browser, failures)
            check_sorting(browser, failures)
            # At desk size: in the emulated phone Chromium 156 takes a minute to print, and its driver gives up before.
            failures.expect(len(browser.print_page()) > 50_000, "the printed page is empty")
            browser.set_window_size(1184, 900)
            check_tables(browser, failures, "1184 pixels")
            check_legend(browser, failures)
            check_controls(browser, failures)
            check_curves(browser, failures, "dark")
            shoot(browser, arguments.screenshots, "dark")
            check_phone(browser, failures)
            check_curves(browser, failures, "phone")
            check_tables(browser, failures, "phone")
            check_words(browser, failures, "phone")
            shoot(browser, arguments.screenshots, "phone")
            check_download(browser, failures, information["records"])
            check_silence(browser, page, failures)
        finally:
            browser.quit()
        size = page.stat().st_size
    failures.expect(size < MOST_BYTES, f"the page has {size} bytes")
    failures.expect(not arguments.most_seconds or seconds < arguments.most_seconds, f"opening took {seconds:.2f} s")
    print(f"{information['records']} records, {charts} charts, {size / 1e6:.2f} MB, open after {seconds:.2f} s")
    print(*failures, f"{len(failures)} failures", sep="\n")
    return 1 if failures else 0


def shoot(browser, folder, name):
    """The whole page as a picture, for people."""
    if folder is None:
        return
    folder.mkdir(parents=True, exist_ok=True)
    shot = browser.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": True, "clip": {
        "x": 0, "y": 0, "scale": 1, "width": browser.execute_script("return innerWidth"),
        "height": min(9000, browser.execute_script("return document.documentElement.scrollHeight"))}})
    (folder / f"{name}.png").write_bytes(base64.b64decode(shot["data"]))


if __name__ == "__main__":
    sys.exit(main())
