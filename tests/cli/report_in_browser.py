# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Opens the report of a results file in headless Chromium and looks at it as a reader would.

    report_in_browser.py --raygauge PROGRAM --results FILE.h5 [--screenshots FOLDER] [--most-seconds S]

Fails on an error on the console, a request to the network, a chart without its curves (by the pixels of their
colours), a control without effect, numbers that are not those of the file, a place that the keyboard does not reach,
content wider than a phone, a download that lacks records, or a page of 5 MB or more. The time to open is printed; it
fails the test only with --most-seconds.
"""
import argparse
import base64
import csv
import io
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from browser import Failures, check_silence, start_browser  # noqa: E402

MOST_BYTES = 5_000_000

# For each visible curve of a chart that no other covers: how many pixels of the canvas nearly have its colour.
CURVE_PIXELS = """
const chart = raygauge.charts[arguments[0]], canvas = chart.canvas;
const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
return chart.data.datasets.map((dataset, index) => {
  const same = (other) => JSON.stringify(other.data.map((p) => [p.x, p.y])) === JSON.stringify(dataset.data.map((p) => [p.x, p.y]));
  const covered = chart.data.datasets.findIndex(same) < index;  // another curve lies on it, point for point
  if (!chart.isDatasetVisible(index) || covered) return -1;
  const [r, g, b] = [1, 3, 5].map((i) => parseInt(dataset.borderColor.slice(i, i + 2), 16));
  let count = 0;
  const near = (i) => Math.abs(pixels[i] - r) + Math.abs(pixels[i + 1] - g) + Math.abs(pixels[i + 2] - b) < 24;
  for (let i = 0; i < pixels.length; i += 4) if (pixels[i + 3] > 128 && near(i)) count++;
  return count;
});
"""


def open_page(browser, page):
    """Seconds until everything is drawn."""
    start = time.monotonic()
    browser.get(page.as_uri())
    ready = "return document.documentElement.dataset.ready === 'true'"
    WebDriverWait(browser, 60).until(lambda b: b.execute_script(ready))
    return time.monotonic() - start


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
    canvas = browser.find_elements(By.CSS_SELECTOR, ".chart canvas")[0]
    index = browser.execute_script("return raygauge.charts.findIndex((c) => c.canvas === arguments[0])", canvas)
    before = browser.execute_script(CURVE_PIXELS, index)
    entry = browser.execute_script("return arguments[0].closest('.block').querySelector('.entry')", canvas)
    click = lambda: browser.execute_script("arguments[0].click()", entry)
    click()
    failures.expect(browser.execute_script(CURVE_PIXELS, index)[0] == -1, "the legend hides no curve")
    failures.expect(entry.get_attribute("aria-pressed") == "false", "the legend does not say that a curve is hidden")
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


def check_keyboard(browser, failures):
    """Every chart, legend, map, menu and button is reached by Tab, a map and a legend in one stop; arrows move inside."""
    browser.execute_script("scrollTo(0, 0); document.activeElement.blur()")
    name = """
        const a = document.activeElement;
        if (a === document.body) return null;
        const maps = [...document.querySelectorAll(".heat")], legends = [...document.querySelectorAll(".legend[role=group]")];
        const charts = [...document.querySelectorAll(".chart canvas")];
        if (a.closest(".heat")) return "map " + maps.indexOf(a.closest(".heat"));
        if (a.closest(".legend")) return "legend " + legends.indexOf(a.closest(".legend"));
        return charts.includes(a) ? "chart " + charts.indexOf(a) : a.tagName;"""
    stops = []
    for _ in range(400):
        ActionChains(browser).send_keys(Keys.TAB).perform()
        stop = browser.execute_script(name)
        if stop is None and stops:
            break  # past the end of the page
        stops.append(stop)
    counts = browser.execute_script("""
        return {map: document.querySelectorAll(".heat").length, legend: document.querySelectorAll(".legend[role=group]").length,
                chart: document.querySelectorAll(".chart canvas").length};""")
    for kind, count in counts.items():
        found = [stop for stop in stops if stop and stop.startswith(kind)]
        failures.expect(count > 0 and sorted(found) == sorted(f"{kind} {i}" for i in range(count)),
                        f"the Tab key stops at {found} for {count} of kind {kind}")
    words = "return document.querySelector('#summary .remark').textContent"
    browser.execute_script("document.querySelector('#summary .heat td[tabindex=\"0\"]').focus()")
    first = browser.execute_script(words)
    ActionChains(browser).send_keys(Keys.ARROW_RIGHT).perform()
    failures.expect(first and browser.execute_script(words) != first, f"arrows do not move in the map: {first!r}")


def check_numbers(browser, results, raygauge, failures):
    """The page's own texts of numbers; and what keys say of a chart's point, against the file."""
    texts = browser.execute_script(
        "return [12200, 1e-10, 1e-300, 0, Infinity, 1.2041e-10, null].map((x) => raygauge.short(x))")
    wanted = ["12200", "10⁻¹⁰", "10⁻³⁰⁰", "0", "∞", "1.2·10⁻¹⁰", "–"]
    failures.expect(texts == wanted, f"numbers are told as {texts}, not {wanted}")
    block, series, point = browser.execute_script("""
        const canvas = document.querySelector("#scaling .chart canvas"), chart = raygauge.charts.find((c) => c.canvas === canvas);
        canvas.focus();
        const problem = document.querySelector("[data-shared=problem]");
        const menus = [...canvas.closest(".block").querySelectorAll("select")].map((m) => [m.dataset.facet, m.value]);
        return [menus, chart.data.datasets[0].method, chart.data.datasets[0].data[0].x];""")
    ActionChains(browser).send_keys(Keys.HOME).perform()
    said = browser.execute_script("return document.querySelector('#scaling .remark').textContent")
    facets = dict(block)
    where = f"method=={series} && N=={point:.0f} && n=={facets['n']} && tolerance=={facets['tolerance']}"
    rows = csv.DictReader(io.StringIO(subprocess.check_output([raygauge, "export", results, "--csv", "-", "--where", where], text=True)))
    seconds = statistics.median(float(row["seconds"]) for row in rows if row["status"] == "optimal")
    value, unit = re.search(r": ([0-9.]+) \[.*\] (µs|ms|s)", said).groups()
    shown = float(value) * {"µs": 1e-6, "ms": 1e-3, "s": 1}[unit]
    failures.expect(abs(shown - seconds) < 0.006 * seconds, f"the file's median is {seconds} s, the page says {said!r}")


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


def check_download(browser, failures, exported):
    """The records inside the page are those of the file; times have fewer digits."""
    text = browser.execute_async_script("""
        const done = arguments[arguments.length - 1];
        const block = raygauge.data.sections.flatMap((s) => s.blocks).find((b) => b.type === "records");
        raygauge.unpack(block.gzip).then((text) => done(raygauge.csvOfColumns(text, block.count)), (error) => done(String(error)));""")
    inside, outside = list(csv.DictReader(io.StringIO(text))), list(csv.DictReader(io.StringIO(exported)))
    failures.expect(len(inside) == len(outside), f"the download has {len(inside)} records of {len(outside)}")
    for ours, theirs in zip(inside, outside):
        different = [name for name in theirs if ours.get(name) != theirs[name]]
        close = all(abs(float(ours[name]) - float(theirs[name])) <= 1e-6 * abs(float(theirs[name])) for name in different)
        if not close:
            failures.append(f"the download differs in {different}")
            return


def check_small_page(browser, arguments, folder, failures):
    """A part of the records, few enough to be inside the page."""
    page, few = pathlib.Path(folder) / "small.html", "n==3 && N<=400 && tolerance<1e-5"
    subprocess.run([arguments.raygauge, "report", arguments.results, "-o", str(page), "--where", few], check=True,
                   stdout=subprocess.DEVNULL)
    exported = subprocess.check_output([arguments.raygauge, "export", arguments.results, "--csv", "-", "--where", few], text=True)
    open_page(browser, page)
    check_download(browser, failures, exported)
    check_silence(browser, failures, page.as_uri())


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
            check_keyboard(browser, failures)
            check_numbers(browser, arguments.results, arguments.raygauge, failures)
            check_controls(browser, failures)
            check_curves(browser, failures, "dark")
            shoot(browser, arguments.screenshots, "dark")
            check_phone(browser, failures)
            check_curves(browser, failures, "phone")
            check_tables(browser, failures, "phone")
            check_words(browser, failures, "phone")
            shoot(browser, arguments.screenshots, "phone")
            check_silence(browser, failures, page.as_uri())
            check_small_page(browser, arguments, folder, failures)
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
