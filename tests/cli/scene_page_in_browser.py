# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Opens the page of scenes in headless Chromium and looks at them as a reader would.

    scene_page_in_browser.py --raygauge PROGRAM --scenes FOLDER [--screenshots FOLDER]

Fails on an error on the console, a request to the network, a view without bodies (by its pixels), a control without
effect, a timeline without its curve, an event without its still, or content wider than a phone.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

# How many pixels of the view differ from its corner, which is background.
DRAWN_PIXELS = """
const canvas = document.getElementById('canvas'), copy = document.createElement('canvas');
copy.width = canvas.width; copy.height = canvas.height;
const context = copy.getContext('2d');
context.drawImage(canvas, 0, 0);
const p = context.getImageData(0, 0, copy.width, copy.height).data;
let count = 0;
for (let i = 0; i < p.length; i += 4)
  if (Math.abs(p[i] - p[0]) + Math.abs(p[i + 1] - p[1]) + Math.abs(p[i + 2] - p[2]) > 30) ++count;
return count;
"""


def start_browser(profile):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                     "--disable-dev-shm-usage", "--window-size=1280,900", "--disable-background-networking",
                     f"--user-data-dir={profile}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def look_at(browser, page, scheme, width, failures, screenshot):
    def expect(holds, message):
        if not holds:
            failures.append(f"{page.stem}, {scheme}, {width} px: {message}")

    browser.execute_cdp_cmd("Emulation.setEmulatedMedia",
                            {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600})
    browser.get(page.as_uri())
    if screenshot:
        browser.save_screenshot(str(screenshot))
    expect(browser.execute_script("return document.documentElement.scrollWidth") <= width, "wider than the window")
    drawn = browser.execute_script(DRAWN_PIXELS)
    expect(drawn > 2000, f"only {drawn} pixels of bodies")
    slider = browser.find_element(By.ID, "slider")
    picture = "return document.getElementById('canvas').toDataURL()"
    first = browser.execute_script(picture)
    browser.find_element(By.TAG_NAME, "body").send_keys(Keys.ARROW_RIGHT)
    expect(slider.get_attribute("value") == "1", "the arrow key does not step")
    browser.execute_script("arguments[0].value = arguments[0].max; arguments[0].dispatchEvent(new Event('input'))", slider)
    expect(browser.execute_script(picture) != first, "the slider moves nothing")
    button = browser.find_element(By.ID, "play")
    button.click()
    expect(button.text == "Pause", "play does not start")
    button.click()
    expect(button.text == "Play", "pause does not stop")
    curves = browser.find_elements(By.CSS_SELECTOR, "svg.timeline")
    expect(curves, "no timeline")
    for curve in curves:
        lengths = browser.execute_script(
            "return [...arguments[0].querySelectorAll('path')].map((p) => p.getTotalLength())", curve)
        expect(max(lengths) > 300, "a timeline without a curve")
    expect(browser.find_elements(By.CSS_SELECTOR, "#event-list img"), "no still of an event")
    marks = len(browser.find_elements(By.CSS_SELECTOR, "svg.accuracy circle"))
    expect(marks == (3 if page.stem == "costs" else 0), f"{marks} marks of what accuracy costs")
    for entry in browser.get_log("browser"):
        if entry["level"] == "SEVERE":
            failures.append(f"{page.stem}: console: {entry['message']}")
    for entry in browser.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            url = message["params"]["request"]["url"]
            expect(url == page.as_uri() or url.startswith(("data:", "blob:", "chrome:")), f"request to {url[:100]}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--scenes", type=pathlib.Path, required=True)
    parser.add_argument("--screenshots", type=pathlib.Path)
    arguments = parser.parse_args()
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        pages = []
        for name in ("two_vehicles", "falling_box"):
            results, page = work / f"{name}.h5", work / f"{name}.html"
            subprocess.run([arguments.raygauge, "scene", "run", arguments.scenes / f"{name}.toml", "-q", "-o", results],
                           check=True)
            subprocess.run([arguments.raygauge, "report", results, "-o", page], check=True, stdout=subprocess.DEVNULL)
            pages.append(page)
        # Distances at three tolerances: the page draws what accuracy costs.
        costs = work / "costs.toml"
        text = (arguments.scenes / "two_vehicles.toml").read_text()
        costs.write_text(text.replace('metric_body = "ego"', 'metric_body = "ego"\ntolerance = [1e-2, 1e-5, 1e-8]'))
        subprocess.run([arguments.raygauge, "scene", "run", costs, "-q", "-o", work / "costs.h5"], check=True)
        subprocess.run([arguments.raygauge, "report", work / "costs.h5", "-o", work / "costs.html"], check=True,
                       stdout=subprocess.DEVNULL)
        pages.append(work / "costs.html")
        browser = start_browser(work / "profile")
        try:
            for page in pages:
                for scheme, width in (("light", 1280), ("dark", 1280), ("light", 390)):
                    shot = arguments.screenshots and arguments.screenshots / f"{page.stem}_{scheme}_{width}.png"
                    look_at(browser, page, scheme, width, failures, shot)
        finally:
            browser.quit()
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
