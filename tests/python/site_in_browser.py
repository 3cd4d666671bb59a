# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Opens the documentation site from the disk in headless Chromium, searches it, and looks at the C++ API.

    site_in_browser.py FOLDER [--screenshots FOLDER]     FOLDER: html of the site, built by docs/site/build_site.py

Fails on an error on the console, a request that leaves the disk, a search without the page it is for, a result that leads
nowhere, or content wider than a phone.
"""
import argparse
import html
import pathlib
import re
import sys
import tempfile
import urllib.parse

from selenium.common.exceptions import TimeoutException
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from browser import Failures, check_silence, start_browser  # noqa: E402

# What a reader types, and the page that must be among the results.
SEARCHES = {
    "schema version": "file-format.html",
    "time of impact": "scenes.html",
    "Minkowski": "sets.html",
    "PreparedSet": "python-api.html",
    "warm start": "glossary.html",
}
RESULTS = ".md-search-result__item a.md-search-result__link"


def found_pages(browser, words):
    """The pages that the site's search lists for these words, without anchors and what is to be highlighted."""
    field = browser.find_element(By.CSS_SELECTOR, "input.md-search__input")
    browser.execute_script("arguments[0].focus()", field)
    field.send_keys(words)
    WebDriverWait(browser, 120).until(lambda b: b.find_elements(By.CSS_SELECTOR, RESULTS))
    links = [link.get_attribute("href") for link in browser.find_elements(By.CSS_SELECTOR, RESULTS)]
    return [urllib.parse.urlparse(link)._replace(query="", fragment="").geturl() for link in links]


def check_search(browser, site, start, failures):
    for words, page in SEARCHES.items():
        browser.get((site / start).as_uri())
        pages = found_pages(browser, words)
        if (site / page).as_uri() not in pages:
            failures.append(f"{start}: the search for '{words}' finds {len(pages)} results, but not {page}")
        failures += [f"the search for '{words}' leads to {found}, which is not there" for found in set(pages)
                     if not pathlib.Path(urllib.parse.unquote(urllib.parse.urlparse(found).path)).exists()]


def check_cpp_search(browser, site, failures):
    """Doxygen's own search finds a class and leads to its page."""
    browser.get((site / "cpp" / "index.html").as_uri())
    field = WebDriverWait(browser, 30).until(lambda b: b.find_element(By.ID, "MSearchField"))
    field.send_keys("DistanceSolver")

    def listed(b):
        b.switch_to.default_content()
        frames = b.find_elements(By.ID, "MSearchResults")
        if frames and frames[0].tag_name == "iframe":
            b.switch_to.frame(frames[0])
        return [link.get_attribute("href") for link in b.find_elements(By.CSS_SELECTOR, "a.SRSymbol, .SREntry a")
                if "DistanceSolver" in (link.get_attribute("href") or "") + link.text]

    try:
        WebDriverWait(browser, 30).until(listed)
    except Exception as error:  # selenium's TimeoutException, and what a frame that is replaced raises
        failures.append(f"the C++ API's search does not find DistanceSolver: {type(error).__name__}")
    browser.switch_to.default_content()


def check_width(browser, site, failures, screenshots):
    for width in (1280, 390):
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600})
        for page in ("index.html", "python-api.html", "gallery.html", "cpp/index.html"):
            browser.get((site / page).as_uri())
            if screenshots:
                browser.save_screenshot(str(screenshots / f"{page.replace('/', '_')[:-5]}_{width}.png"))
            if browser.execute_script("return document.documentElement.scrollWidth") > width:
                failures.append(f"{page} is wider than a window of {width} px")


def check_first_page(browser, site, failures):
    """It says what raygauge is before it lists pages, with a picture and a first result."""
    browser.get((site / "index.html").as_uri())
    text = browser.find_element(By.CSS_SELECTOR, "article").text
    places = [text.find(words) for words in ("By how much must a convex set Q be scaled", "distance   3.5", "experiments.md")]
    if -1 in places or places != sorted(places):
        failures.append(f"the first page does not say what raygauge is and show a result before it lists pages: {places}")
    width = browser.execute_script("const i = document.querySelector('article img'); return i ? i.naturalWidth : 0")
    if width < 100:
        failures.append("the first page has no picture")


def check_dark(browser, site, failures):
    """The grounds of both parts of the site are dark where the reader's system asks for it, and light where not."""
    ground = """const c = getComputedStyle(document.body).backgroundColor.match(/[\\d.]+/g).map(Number);
                return (c[0] + c[1] + c[2]) / 3"""
    for scheme, fits in (("dark", lambda light: light < 100), ("light", lambda light: light > 200)):
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        for page in ("index.html", "cpp/index.html"):
            browser.get((site / page).as_uri())
            browser.execute_script("localStorage.clear()")  # a new reader: the theme remembers what it has shown
            browser.refresh()
            try:
                WebDriverWait(browser, 20).until(lambda b: fits(b.execute_script(ground)))
            except TimeoutException:
                light = browser.execute_script(ground)
                failures.append(f"{page}: a ground of brightness {light} where the system is {scheme}")
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})


def check_cpp_includes(site, failures):
    """The page of a class says what to include, and descriptions are whole sentences."""
    page = next(page for page in (site / "cpp").glob("classraygauge_1_1*all.html") if "Ball" in page.name or "ball" in page.name)
    text = html.unescape(re.sub(r"<[^>]+>", "", page.read_text(encoding="utf-8")))
    if "#include <raygauge/sets/ball.h>" not in text:
        failures.append(f"{page.name} does not say #include <raygauge/sets/ball.h>")
    classes = (site / "cpp" / "annotated.html").read_text(encoding="utf-8")
    briefs = [html.unescape(re.sub(r"<[^>]+>", "", brief)).strip()
              for brief in re.findall(r'(?s)<td class="desc">(.*?)</td>', classes)]
    if len(briefs) < 50:
        failures.append(f"the list of classes has {len(briefs)} descriptions")
    failures += [f"the list of classes breaks off: '…{brief[-60:]}'" for brief in briefs
                 if re.search(r"([:,=]|\b(gives|is|of|and|that|where|for))$", brief)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("site", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path)
    arguments = parser.parse_args()
    site = arguments.site.resolve()
    failures = Failures()
    with tempfile.TemporaryDirectory() as profile:
        browser = start_browser(profile)
        try:
            check_search(browser, site, "index.html", failures)
            check_search(browser, site, "sets.html", failures)
            check_cpp_search(browser, site, failures)
            check_first_page(browser, site, failures)
            check_dark(browser, site, failures)
            check_cpp_includes(site, failures)
            check_width(browser, site, failures, arguments.screenshots)
            check_silence(browser, failures, "file:")
        finally:
            browser.quit()
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
