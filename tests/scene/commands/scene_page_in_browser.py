# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Opens the pages of scenes in headless Chromium and looks at them as a reader would.

    scene_page_in_browser.py --raygauge PROGRAM --scenes FOLDER [--screenshots FOLDER]

Fails on an error on the console, a request to the network, a view without bodies (by its pixels), a control without
effect, a timeline without its curve, a first line without an answer, events that are not those of the file, a number
that is not the file's, a colour without a legend, something that the keyboard does not reach, or content wider than a
phone.
"""
import argparse
import csv
import io
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from browser import Failures, check_silence, start_browser  # noqa: E402

# How many pixels of the view differ from those of the picture without bodies in it.
DRAWN_PIXELS = """
const canvas = document.getElementById('canvas'), copy = document.createElement('canvas');
copy.width = canvas.width; copy.height = canvas.height;
const context = copy.getContext('2d');
context.drawImage(canvas, 0, 0);
const p = context.getImageData(0, 0, copy.width, copy.height).data;
let count = 0;
for (let i = 0; i < p.length; i += 4)
  if (Math.max(p[i], p[i + 1], p[i + 2]) - Math.min(p[i], p[i + 1], p[i + 2]) > 40 || (p[i] > 100 && p[i] < 170)) ++count;
return count;
"""

# Five instants of two boxes; the numbers are then put in their place.
FIVE = """
[time]
to = 4
instants = 5
[[body]]
name = "left"
shape = { shape = "box", lower = [-1, -1, -1], upper = [1, 1, 1] }
[[body]]
name = "right"
shape = { shape = "box", lower = [3, -1, -1], upper = [5, 1, 1] }
motion = { velocity = [0.1, 0, 0] }
[[query]]
name = "numbers"
effects = ["distance"]
"""
NUMBERS = [12200, 1e-10, 1e-300, 0, math.inf]

VERDICTS = {"two_vehicles": "safe: never closer than ", "falling_box": "not safe: ", "costs": "safe: never closer than ",
            "arm": "safe: never closer than ", "gripper": "not safe: ", "grasp": "contact forces that the task needs: 1.06"}


def expected_events(raygauge, results):
    """How many events there are, by the records alone: one a time of impact or clearance; for each query and pair at
    instants the changes of its status, and its least value, or that it was apart throughout."""
    text = subprocess.check_output([raygauge, "export", results, "--csv", "-"], text=True)
    count, tracks = 0, {}
    for row in csv.DictReader(io.StringIO(text)):
        if row["kind"] == "instant":
            tracks.setdefault((row["query"], row["body_a"], row["body_b"]), []).append(row)
        else:
            count += 1
    for track in tracks.values():
        words = [row["status"] for row in track]
        count += (words[0] == "intersecting") + sum(a != b for a, b in zip(words, words[1:]))
        valued = any(row["distance"] != "nan" or row["growth"] != "nan" for row in track)
        count += valued or all(word == "separated" for word in words)
    return count


class Page:
    def __init__(self, browser, path, failures, scheme="light", width=1280):
        self.browser, self.path, self.failures, self.name = browser, path, failures, f"{path.stem}, {scheme}, {width} px"
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600})
        browser.get(path.as_uri())
        self.width = width

    def expect(self, holds, message):
        if not holds:
            self.failures.append(f"{self.name}: {message}")

    def find(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def text(self, identifier):
        return self.browser.execute_script("return document.getElementById(arguments[0]).textContent", identifier)

    def value(self):
        return int(self.browser.find_element(By.ID, "slider").get_attribute("value"))

    def press(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

    def check_first_line(self):
        first = self.browser.execute_script("return document.querySelector('main').innerText.split('\\n')[0]")
        self.expect(first.startswith(VERDICTS[self.path.stem]), f"the first line is {first!r}")

    def check_view(self):
        drawn = self.browser.execute_script(DRAWN_PIXELS)
        self.expect(drawn > 2000, f"only {drawn} pixels of bodies")
        picture = "return document.getElementById('canvas').toDataURL()"
        first = self.browser.execute_script(picture)
        self.browser.find_element(By.TAG_NAME, "body").send_keys(Keys.ARROW_RIGHT)
        self.expect(self.value() == 1, "the arrow key does not step")
        self.browser.execute_script("const s = document.getElementById('slider'); s.value = s.max; s.dispatchEvent(new Event('input'))")
        self.expect(self.browser.execute_script(picture) != first, "the slider moves nothing")
        button = self.browser.find_element(By.ID, "play")
        button.click()
        self.expect(button.text == "Pause", "play does not start")
        button.click()
        self.expect(button.text == "Play", "pause does not stop")
        legend = self.text("legend")
        for words in ("in contact", "asked", "squares of"):
            self.expect(words in legend, f"the legend {legend!r} lacks {words!r}")

    def check_names(self):
        """Pointing at a body names it."""
        place = self.browser.execute_script("""
            page.show(0);
            const canvas = document.getElementById('canvas'), w = canvas.width, h = canvas.height;
            for (let y = 5; y < h; y += 10) for (let x = 5; x < w; x += 10) {
              const body = page.view.pick(x, y), near = page.view.pick(x + 6, y + 6);
              if (body !== null && body === near) return [(x + 3) * canvas.clientWidth / w, (y + 3) * canvas.clientHeight / h, page.data.bodies[body]];
            }
            return null;""")
        self.expect(place is not None, "no body is found in the picture")
        if place is None:
            return
        canvas = self.browser.find_element(By.ID, "canvas")
        size = canvas.size
        ActionChains(self.browser).move_to_element_with_offset(
            canvas, int(place[0] - size["width"] / 2), int(place[1] - size["height"] / 2)).perform()
        self.expect(self.text("name") == place[2], f"pointing at {place[2]!r} says {self.text('name')!r}")

    def check_timelines(self):
        curves = self.find("svg.timeline")
        self.expect(curves, "no timeline")
        for curve in curves:
            lengths = self.browser.execute_script(
                "return [...arguments[0].querySelectorAll('path')].map((p) => p.getTotalLength())", curve)
            self.expect(max(lengths) > 300, "a timeline without a curve")

    def check_events(self, count):
        items = self.find("#event-list li")
        self.expect(len(items) == count, f"{len(items)} events for {count} in the file")
        self.expect(f"{count} events" == self.text("count"), f"the count says {self.text('count')!r}")
        order = ["contact", "undecided", "near", "free", "release"]
        kinds = [item.get_attribute("data-kind") for item in items]
        self.expect(kinds == sorted(kinds, key=order.index), f"events not by danger: {kinds}")
        menu = Select(self.browser.find_element(By.ID, "kind"))
        menu.select_by_index(len(menu.options) - 1)
        kind = menu.options[-1].get_attribute("value")
        shown = self.browser.execute_script("return [...document.querySelectorAll('#event-list li')].filter((li) => !li.hidden).length")
        self.expect(shown == kinds.count(kind), f"the filter {kind} shows {shown} of {kinds.count(kind)}")
        menu.select_by_index(0)
        words = self.browser.find_element(By.ID, "words")
        words.send_keys("no such body")
        shown = self.browser.execute_script("return [...document.querySelectorAll('#event-list li')].filter((li) => !li.hidden).length")
        self.expect(shown == 0, f"words of no event show {shown}")
        words.send_keys(Keys.CONTROL, "a")
        words.send_keys(Keys.DELETE)

    def check_click(self):
        """A click on the last event moves the picture, which stays in view."""
        self.browser.execute_script("page.show(page.times.length - 1)")
        timed = self.browser.execute_script("return page.data.events.map((e) => e.time === null ? null : page.frameOf(e.time))")
        at = next((i for i in reversed(range(len(timed))) if timed[i] is not None), None)
        if at is None:
            return
        button = self.find("#event-list button")[at]
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", button)
        button.click()
        self.expect(self.value() == timed[at], f"a click on an event moves the picture to {self.value()}, not {timed[at]}")
        box = self.browser.execute_script("const b = document.getElementById('canvas').getBoundingClientRect(); return [b.top, b.bottom, innerHeight]")
        self.expect(box[0] >= -1 and box[1] <= box[2] + 1, f"after the click the picture is at {box}")

    def check_keyboard(self):
        """The Tab key reaches everything in few stops; arrows do the rest."""
        self.browser.execute_script("scrollTo(0, 0); document.activeElement.blur()")
        stops = []
        for _ in range(80):
            self.press(Keys.TAB)
            stop = self.browser.execute_script(
                "const a = document.activeElement; return a === document.body ? '' : a.id || (a.closest('[id]') || a).id + ' ' + a.tagName")
            if stops and stop == stops[0]:
                break  # once around
            if stop:
                stops.append(stop)
        lists = [stop for stop in stops if stop.startswith(("event-list", "body-list"))]
        self.expect(len([stop for stop in lists if stop == "event-list BUTTON"]) == 1, f"the events are not one stop: {stops}")
        wanted = ["kind", "words"]
        if self.find("#canvas"):
            wanted += ["canvas", "play", "slider", "body-list BUTTON"]
        for stop in wanted:
            self.expect(stop in stops, f"the Tab key does not reach {stop}: {stops}")
        timelines = len(self.find("svg.timeline"))
        self.expect(sum(stop == "timelines svg" for stop in stops) == timelines, f"the Tab key does not reach every timeline: {stops}")
        if not self.find("#canvas"):
            return
        self.browser.execute_script("page.show(0); document.querySelector('svg.timeline').focus()")
        self.press(Keys.END)
        self.expect(self.value() > 0, "a timeline does not move the picture by keys")
        self.expect("certified [" in self.find("#timelines output")[0].text, "a timeline does not tell its point")
        self.browser.execute_script("document.querySelector('#event-list button[tabindex=\"0\"]').focus()")
        before = self.browser.execute_script("return document.activeElement.textContent")
        if len(self.find("#event-list button")) > 1:
            self.press(Keys.ARROW_DOWN)
            self.expect(self.browser.execute_script("return document.activeElement.textContent") != before, "arrows do not move among events")
        self.browser.execute_script("document.querySelector('#body-list button[tabindex=\"0\"]').focus()")
        self.expect(self.text("name") == self.browser.execute_script("return document.activeElement.textContent"), "a body in the list is not named in the picture")
        if self.browser.execute_script("return page.drawing.dimension") == 3:
            picture = "return document.getElementById('canvas').toDataURL()"
            self.browser.execute_script("document.getElementById('canvas').focus()")
            first = self.browser.execute_script(picture)
            self.press(Keys.ARROW_LEFT)
            self.expect(self.browser.execute_script(picture) != first, "keys do not turn the picture")


def number(text):
    return math.inf if text == "∞" else float(text)


def check_numbers(page, results):
    """What the timeline and the table of queries say, against the file."""
    with h5py.File(results) as file:
        distances, tolerance = list(file["records/distance"]), file["queries/tolerance"][0]
    page.browser.execute_script("document.querySelector('svg.timeline').focus()")
    page.press(Keys.HOME)
    for k, distance in enumerate(distances):
        words = page.find("#timelines output")[0].text
        found = re.match(r"at (\S+) s: (\S+) m, certified \[(\S+), (\S+)\] m, left – right", words)
        same = found and all(number(part) == number(f"{distance:.5g}") for part in found.groups()[1:])
        page.expect(same and float(found.group(1)) == k, f"{distance} is shown as {words!r}")
        page.press(Keys.ARROW_RIGHT)
    cells = [cell.text for cell in page.find("#tallies td")]
    page.expect(number(cells[7]) == float(f"{tolerance:.5g}"), f"the tolerance {tolerance} is shown as {cells[7]}")
    least = page.find("#event-list button")[0].text
    page.expect("least distance 0 m at the instant 3 s" in least, f"the least distance is told as {least!r}")


def make(arguments, work, name, text=None):
    """Results and page of a scene."""
    scene = arguments.scenes / f"{name}.toml"
    if text is not None:
        scene = work / f"{name}.toml"
        scene.write_text(text)
    results, page = work / f"{name}.h5", work / f"{name}.html"
    subprocess.run([arguments.raygauge, "scene", "run", scene, "-q", "-o", results], check=True)
    subprocess.run([arguments.raygauge, "report", results, "-o", page], check=True, stdout=subprocess.DEVNULL)
    return results, page


def make_numbers(arguments, work):
    results, page = make(arguments, work, "numbers", FIVE)
    with h5py.File(results, "r+") as file:
        for column in ("distance", "lower", "upper"):
            file[f"records/{column}"][...] = NUMBERS
        file["queries/tolerance"][...] = 1e-10
    subprocess.run([arguments.raygauge, "report", results, "-o", page], check=True, stdout=subprocess.DEVNULL)
    return results, page


def look_at(browser, page_path, results, scheme, width, arguments, failures):
    page = Page(browser, page_path, failures, scheme, width)
    if arguments.screenshots:
        arguments.screenshots.mkdir(parents=True, exist_ok=True)
        browser.save_screenshot(str(arguments.screenshots / f"{page_path.stem}_{scheme}_{width}.png"))
    page.expect(browser.execute_script("return document.documentElement.scrollWidth") <= width, "wider than the window")
    page.check_first_line()
    if page_path.stem == "grasp":
        rows = page.find("#grasp-table tr")
        page.expect(len(rows) == 9, f"{len(rows)} rows of the quality of 8 grasps")
    else:
        page.check_view()
        page.check_timelines()
        page.check_click()
    marks = len(page.find("svg.accuracy circle"))
    page.expect(marks == (3 if page_path.stem == "costs" else 0), f"{marks} marks of what accuracy costs")
    if marks:
        words = [row.text.split()[0] for row in page.find("table.costs tr")[1:]]
        page.expect(words == ["0.01", "1e-5", "1e-8"], f"the tolerances are {words}")
    if width > 1000 and scheme == "light":
        page.check_events(expected_events(arguments.raygauge, results))
        page.check_keyboard()
        if page_path.stem != "grasp":
            page.check_names()
    check_silence(browser, page, page.path.as_uri())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--scenes", type=pathlib.Path, required=True)
    parser.add_argument("--screenshots", type=pathlib.Path)
    arguments = parser.parse_args()
    failures = Failures()
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        pages = [make(arguments, work, name) for name in ("two_vehicles", "falling_box", "arm", "gripper", "grasp")]
        # Distances at three tolerances: the page draws what accuracy costs.
        text = (arguments.scenes / "two_vehicles.toml").read_text()
        costs = text.replace('metric_body = "ego"', 'metric_body = "ego"\ntolerance = [1e-2, 1e-5, 1e-8]')
        pages.append(make(arguments, work, "costs", costs))
        numbers = make_numbers(arguments, work)
        browser = start_browser(work / "profile", draws_in_3d=True)
        try:
            for results, page in pages:
                for scheme, width in (("light", 1280), ("dark", 1280), ("light", 390)):
                    look_at(browser, page, results, scheme, width, arguments, failures)
            page = Page(browser, numbers[1], failures)
            check_numbers(page, numbers[0])
            check_silence(browser, page, page.path.as_uri())
        finally:
            browser.quit()
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
