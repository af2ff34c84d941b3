#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""design_points.py: the design points of sim/design/design_points.def: prints a line `NAME key=value ...` for each."""
import os
import re

TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../sim/design/design_points.def")


def design_points():
    """{name: ["key=value", ...]} in the order of the table."""
    with open(TABLE, encoding="utf-8") as file:
        points = re.findall(r"^PIPEGS_POINT\((\w+), (.*?)^PIPEGS_END\(", file.read(), re.DOTALL | re.MULTILINE)
    setting = re.compile(r"^PIPEGS_(?:SETTING|PICTURE)\((\w+), (\d+)\)", re.MULTILINE)
    return {name: [f"{key}={value}" for key, value in setting.findall(text)] for name, text in points}


if __name__ == "__main__":
    for point, settings in design_points().items():
        print(point, *settings)
