#include "lancer/app/figures/page.h"

#include <fmt/format.h>

#include "lancer/app/figures/figures.h"
#include "lancer/app/figures/table.h"

namespace lancer::app {

namespace {

std::string html(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string picture(const std::string& file, const std::string& caption) {
    return fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>", html(file), html(caption));
}

std::string figure_html(const Figure& figure) {
    std::string text = "<figure id=\"" + html(figure.id) + "\">\n" + picture(figure.id + ".png", figure.caption);
    if (figure.enlarged) {
        text += "\n" + picture(figure.id + "-enlarged.png", "A part, enlarged");
    }
    if (figure.sample_map) {
        text += "\n" + picture(figure.id + "-samples.png", "Samples a pixel");
    }
    return text + fmt::format("\n<figcaption>{} <a href=\"{}\">Scene</a>\n<code>{}</code></figcaption>\n</figure>\n", html(figure.caption),
                              html(figure.scene), html(figure_command(figure)));
}

std::string timings_html(const std::vector<Timing>& timings) {
    std::string text =
        "<section id=\"threads\">\n<h2>Threads</h2>\n<p>Figure 1 again, timed.</p>\n<figure>\n"
        "<a href=\"threads.svg\"><img src=\"threads.png\" alt=\"Speed-up over threads\"></a>\n<figcaption>"
        "How much faster more threads are. As <a href=\"threads.svg\">SVG</a>.\n<code>lancer bench</code></figcaption>\n</figure>\n"
        "<table>\n<tr><th>threads</th><th>seconds</th><th>times faster</th><th>million rays a second</th></tr>\n";
    for (const Timing& timing : timings) {
        text += fmt::format("<tr><td>{}</td><td>{:.3f}</td><td>{:.2f}</td><td>{:.1f}</td></tr>\n", timing.threads, timing.seconds,
                            timings.front().seconds / timing.seconds, 1e-6 * static_cast<double>(timing.rays) / timing.seconds);
    }
    return text + "</table>\n</section>\n";
}

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>lancer: figures</title>
<style>
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 1280px; margin: 2rem auto; padding: 0 1rem; }
section > div { display: grid; grid-template-columns: repeat(auto-fill, minmax(400px, 1fr)); gap: 1.5rem; }
section > div:has(> :only-child) { grid-template-columns: 1fr; }
figure { margin: 0; }
img { max-width: 100%; height: auto; display: block; margin-bottom: 0.5rem; }
code { display: block; overflow-x: auto; white-space: nowrap; font-size: 0.8rem; opacity: 0.8; }
td, th { padding: 0 1rem 0 0; text-align: right; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>lancer: figures</h1>
<p>Each picture can be made again, here in this folder, with the command below it.</p>
)";

}  // namespace

std::string figures_page(const std::function<bool(const Figure&)>& is_made, const std::vector<Timing>& timings) {
    std::string page = head;
    for (const FigureGroup& group : figure_table()) {
        std::string figures;
        for (const Figure& figure : group.figures) {
            figures += is_made(figure) ? figure_html(figure) : "";
        }
        if (!figures.empty()) {
            page += fmt::format("<section>\n<h2>{}</h2>\n{}<div>\n{}</div>\n</section>\n", html(group.title),
                                group.text.empty() ? "" : fmt::format("<p>{}</p>\n", html(group.text)), figures);
        }
    }
    if (!timings.empty()) {
        page += timings_html(timings);
    }
    return page + fmt::format("<p>Made by lancer {}.</p>\n</body>\n</html>\n", LANCER_VERSION);
}

}  // namespace lancer::app
