// SPDX-License-Identifier: Apache-2.0
// page.cpp: see page.hpp. XHTML without scripts: every tag is closed.
#include "sim/study/accuracy/sweep/page.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace pipegs {
namespace {

constexpr int kPictureWidth = 480;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else result += c;
  }
  return result;
}

// A chart inside a page: without the XML declaration of a file of its own.
std::string inline_svg(const std::vector<Chart>& charts, int columns) {
  const std::string svg = charts_svg(charts, columns);
  return svg.substr(svg.find("<svg"));
}

std::string png_bytes(const Rgb8& picture) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("pipegs_error_{}.png", getpid());
  write_png8(path, picture);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::remove(path);
  return bytes;
}

std::string point_row(const std::string& name, const MeasuredPoint& point, const Config& base) {
  const Accuracy& a = point.figures;
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.5f}</td><td>{:.4f}</td><td>{:.4f}</td><td>{:.4f}</"
      "td><td>{}</td><td>{:.3f}</td><td>{}</td><td>{}</td>"
      "<td>{:.1f}</td><td>{:.1f}</td><td>{:.1f}</td><td>{}</td><td>{}</td><td class=\"left\">{}</td></tr>\n",
      escaped(name), decibels(a.numeric.psnr), decibels(a.order.psnr), decibels(a.total.psnr), a.total.ssim,
      a.numeric.max, a.numeric.p999, 100 * a.flips.share(), a.cycles, static_cast<double>(a.cycles) * 1e-6,
      clock_text(point), time_text(point), static_cast<double>(a.bytes) / 1e6, a.gbps(), a.buffer_kb(),
      area_text(point), energy_text(point), escaped(difference(point.config, base)));
}

std::string table(const std::string& rows) {
  return "<div class=\"wide\"><table><tr><th></th><th>numeric dB</th><th>order dB</th><th>total "
         "dB</th><th>SSIM</th><th>max</th><th>99.9 %</th>"
         "<th>flips %</th><th>cycles</th><th>ms at 1 "
         "GHz</th><th>GHz</th><th>us</th><th>MB</th><th>GB/s</th><th>buffers "
         "KB</th><th>mm2</th><th>mJ</th><th>configuration</th></tr>\n" +
         rows + "</table></div>\n";
}

std::string front_table(const AccuracySweep& sweep, Cost cost) {
  std::string rows;
  const std::vector<MeasuredPoint> all = sweep.all();
  for (const MeasuredPoint* point : pareto_front(all, cost)) rows += point_row("", *point, sweep.base.config);
  if (rows.empty() && cost == Cost::kTime) rows = "<tr><td>no longest path of such a machine is known</td></tr>\n";
  return table(rows);
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    const size_t n = std::min<size_t>(3, bytes.size() - i);
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += k <= n ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

Rgb8 error_picture(const Image& image, const Image& truth, double gain, int width) {
  const int step = std::max(1, (image.width + width - 1) / width);
  Image small((image.width + step - 1) / step, (image.height + step - 1) / step);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec3 error = gain * glm::abs(image.rgb[image.at(x, y)] - truth.rgb[truth.at(x, y)]);
      glm::dvec3& largest = small.rgb[small.at(x / step, y / step)];
      largest = glm::max(largest, error);
    }
  }
  return to_rgb8(small, glm::dvec3(0));
}

std::vector<ErrorPicture> error_pictures(const AccuracyView& view, const AccuracySweep& sweep) {
  const std::vector<MeasuredPoint> all = sweep.all();
  std::vector<std::pair<std::string, const MeasuredPoint*>> chosen = {{"base", &all.front()}};
  for (const int level : {40, 50, 60, 70, 80}) {
    const MeasuredPoint* point = cheapest(all, level);
    if (point != nullptr) chosen.emplace_back(fmt::format("cheapest at {} dB", level), point);
  }
  const std::vector<const MeasuredPoint*> front = pareto_front(all, Cost::kCycles);
  if (!front.empty()) chosen.emplace_back("most accurate", front.back());
  std::vector<ErrorPicture> pictures;
  std::vector<const MeasuredPoint*> shown;
  for (const auto& [name, point] : chosen) {
    if (std::find(shown.begin(), shown.end(), point) != shown.end()) continue;
    shown.push_back(point);
    const Rgb8 picture = error_picture(view.golden(point->config), view.exact(), kErrorGain, kPictureWidth);
    pictures.push_back({fmt::format("{}: {} dB numeric, {} dB total: {}", name, decibels(point->figures.numeric.psnr),
                                    decibels(point->figures.total.psnr), difference(point->config, sweep.base.config)),
                        png_bytes(picture)});
  }
  return pictures;
}

std::string accuracy_page(const std::string& title, const AccuracySweep& sweep,
                          const std::vector<ErrorPicture>& pictures) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width\"/><meta name=\"color-scheme\" content=\"light "
      "dark\"/><title>{0}</title>\n<style>\n"
      "body {{ font-family: system-ui, sans-serif; max-width: 62rem; margin: 1.5rem auto; padding: 0 1rem; "
      "line-height: 1.45; }}\n"
      "table {{ border-collapse: collapse; font-size: 0.8rem; }} th, td {{ text-align: right; padding: 0.15rem 0.5rem; "
      "white-space: nowrap; }}\n"
      "td.left {{ text-align: left; }} .wide {{ overflow-x: auto; }} svg {{ max-width: 100%; height: auto; }} figure "
      "{{ display: inline-block; width: 30%; margin: 0.5rem 1%; "
      "vertical-align: top; }}\nfigure img {{ width: 100%; background: black; }} figcaption {{ font-size: 0.75rem; "
      "overflow-wrap: anywhere; }}\n"
      ".knob {{ display: inline-block; width: 32%; vertical-align: top; font-size: 0.85rem; "
      "}}\n</style></head><body>\n<h1>{0}</h1>\n"
      "<p>numeric: golden model against float64 in the same order; order: float64 in that order against depth order; "
      "total: golden model against depth "
      "order. Cycles and bytes by the timing model, milliseconds at 1 GHz, SSIM of the total, max and 99.9th "
      "percentile of the numeric error, flips: "
      "decisions at 1/255 unlike the truth's, of {1:.0f} % of the pixels. Area and energy with DRAM: 28 nm, mid, "
      "interpolated; ~ beyond what was synthesised or measured.</p>\n",
      escaped(title), 100 * sweep.flips_sampled);
  page += "<h2>The base</h2>\n" + table(point_row("base", sweep.base, Config{}));
  page += "<h2>What is worth having</h2>\n" + inline_svg(front_charts(sweep), 2);
  page += "<h3>Front over cycles</h3>\n" + front_table(sweep, Cost::kCycles) + "<h3>Front over time</h3>\n" +
          front_table(sweep, Cost::kTime) + "<h3>Front over bytes</h3>\n" + front_table(sweep, Cost::kBytes) +
          "<h3>Front over buffers</h3>\n" + front_table(sweep, Cost::kBuffers) + "<h3>Front over area</h3>\n" +
          front_table(sweep, Cost::kArea) + "<h3>Front over energy</h3>\n" + front_table(sweep, Cost::kEnergy);
  page += "<h2>Knob by knob</h2>\n";
  for (const SweptKnob& knob : sweep.knobs) {
    page += fmt::format("<div class=\"knob\">{}<p>{}. {}</p></div>\n", inline_svg({knob_chart(knob)}, 1),
                        escaped(knob.knob->what), escaped(knob_sentence(knob)));
  }
  page += fmt::format("<h2>Where the error is</h2>\n<p>|golden - truth in depth order|, {:g} times brighter.</p>\n",
                      kErrorGain);
  for (const ErrorPicture& picture : pictures) {
    page += fmt::format(
        "<figure><img alt=\"error\" src=\"data:image/png;base64,{}\"/><figcaption>{}</figcaption></figure>\n",
        base64(picture.png), escaped(picture.caption));
  }
  page += "<h2>Every point</h2>\n";
  for (const SweptKnob& knob : sweep.knobs) {
    std::string rows;
    for (size_t i = 0; i < knob.points.size(); ++i) {
      if (knob.points[i].figures.failure.empty())
        rows += point_row(knob.values[i]->label, knob.points[i], sweep.base.config);
    }
    page += fmt::format("<h3>{}</h3>\n{}", escaped(knob.knob->name), table(rows));
  }
  return page + "</body></html>\n";
}

}  // namespace pipegs
