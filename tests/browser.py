# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What tests that look at pages share: headless Chromium, and what its logs say."""
import json
import shutil

from selenium import webdriver
from selenium.webdriver.chrome.service import Service


class Failures(list):
    def expect(self, holds, message):
        if not holds:
            self.append(message)


def start_browser(profile, draws_in_3d=False):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    drawing = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader") if draws_in_3d else ("--disable-gpu",)
    for argument in ("--headless=new", "--no-sandbox", *drawing, "--disable-dev-shm-usage", "--window-size=1280,900",
                     "--disable-background-networking", f"--user-data-dir={profile}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def check_silence(browser, failures, page):
    """Nothing on the console, and no request but for what begins with the address `page`."""
    for entry in browser.get_log("browser"):
        own = "readback operations" in entry["message"]  # of a test that counts pixels, not of the page
        failures.expect(own, f"console: {entry['message']}")
    for entry in browser.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            url = message["params"]["request"]["url"]
            failures.expect(url.startswith((page, "data:", "blob:", "chrome:")), f"request to {url[:200]}")
