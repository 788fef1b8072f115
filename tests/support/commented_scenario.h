// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario file with comments beside and above its lines, random edits of it, and the lines that they must
// not change.
#pragma once

#include <algorithm>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/yaml/scenario_file.h"

namespace drillwave::test {

inline Section piece(const std::string& name, double length, double diameter) {
    Section section;
    section.name = name;
    section.length = length;
    section.diameter = diameter;
    return section;
}

class CommentedScenario {
  public:
    enum class Layout { points, corners, string, blockString };
    static constexpr int layouts = 4;

    CommentedScenario(Layout layout, std::mt19937_64& random) : m_layout(layout) {
        const std::string lineEnd = random() % 3 == 0 ? "\r\n" : "\n";
        std::istringstream lines(textOf(layout));
        std::string text;
        int number = 0;
        for (std::string line; std::getline(lines, line); ++number) {
            if (random() % 3 == 0) text += "  # above line " + std::to_string(number) + lineEnd;
            text += line + std::string(1 + random() % 4, ' ') + "# line " + std::to_string(number) + lineEnd;
        }
        reopen(parseScenario(text, "test.yaml"));
    }

    /// Replaces the scenario by a saved file, of which no line has been edited yet.
    void reopen(ScenarioDocument saved) {
        document = std::move(saved);
        m_touched.clear();
        const Scenario& scenario = document.scenario;
        m_points = items("- [", scenario.pulse.tablePoints.size());
        m_corners = items("- {force", scenario.bitRock.corners.size());
        m_choices = items("- rod.", document.design.choose.size());
        m_parts = items("- {name", scenario.drillString.parts.size());
    }

    ScenarioDocument document;

    /// Makes one random edit of a number, a word or a list item.
    void edit(std::mt19937_64& random) {
        Scenario& scenario = document.scenario;
        const double factor = 1 + 0.1 * static_cast<double>(1 + random() % 9) / 7;
        switch (random() % 6) {
            case 0:
                scenario.drill.thrust = 8000 * factor;
                return touch("thrust:");
            case 1:
                scenario.bitRock.stiffness = 1e8 * factor;
                return touch("stiffness:");
            case 2:
                scenario.title = "Title " + std::to_string(random() % 100);
                return touch("title:");
            case 3:
                scenario.drill.blowFrequency =
                    scenario.drill.blowFrequency ? std::optional<double>() : std::optional(60 * factor);
                return touch("blow_frequency:");
            case 4:
                editList(m_choices, random, document.design.choose, [&](std::size_t) {
                    return "rod.length=" + std::to_string(random() % 1000) + "mm:9m:5";
                });
                document.design.samples = 16 + random() % 100;
                return touch("samples:");
            default:
                return editOwnList(random, factor);
        }
    }

    /// Returns the lines with a comment that no edit has changed, in order, each with its line end. Lines
    /// with only a comment are included.
    std::vector<std::string> untouchedLines() const {
        std::vector<std::string> lines;
        for (std::size_t at = 0; at < document.text.size();) {
            const std::size_t end = document.text.find('\n', at) + 1;
            const std::string line = document.text.substr(at, end - at);
            at = end;
            const bool isTouched = std::ranges::any_of(m_touched, [&](const std::string& part) {
                return line.find(part) != std::string::npos && line.find("# above") == std::string::npos;
            });
            if (!isTouched && line.find('#') != std::string::npos) lines.push_back(line);
        }
        return lines;
    }

  private:
    static std::string textOf(Layout layout) {
        const std::string rod =
            "rod:\n  length: 3.66 m\n  diameter: 38 mm\n  youngs_modulus: 210 GPa\n"
            "  density: 7850 kg/m^3\n";
        const std::string rest =
            "drill:\n  blow_frequency: 60 Hz\n  thrust: 8 kN\ndesign:\n  choose:\n"
            "    - rod.length=3m:4m:5\n    - rod.diameter=38mm:52mm:3\n  samples: 64\n";
        switch (layout) {
            case Layout::points:
                return "drillwave: 1\ntitle: Points\n" + rod +
                       "pulse:\n  shape: table\n  points:\n    - [0 us, 0 kN]\n    - [50 us, 200 kN]\n"
                       "    - [100 us, 250 kN]\n    - [150 us, 180 kN]\n    - [200 us, 0 kN]\n"
                       "bit_rock:\n  stiffness: 105 MN/m\n  gamma: 0.1\n" +
                       rest;
            case Layout::corners:
                return "drillwave: 1\ntitle: Corners\n" + rod +
                       "pulse:\n  shape: rectangular\n  duration: 200 us\n  impulse: 51 N s\nbit_rock:\n"
                       "  law: corners\n  corners:\n    - {force: 60 kN, slope: 0.5}\n"
                       "    - {force: 90 kN, slope: 0.35}\n    - {force: 140 kN, slope: 0.2}\n"
                       "  stiffness: 250 MN/m\n  gamma: 0.15\n" +
                       rest;
            case Layout::string:
                return "drillwave: 2\ntitle: String\nmaterial: {youngs_modulus: 210 GPa, density: 7850 "
                       "kg/m^3}\n"
                       "hammer:\n  velocity: 10 m/s\n  sections:\n    - {length: 300 mm, diameter: 50 mm}\n"
                       "string:\n  - {name: adapter, length: 450 mm, diameter: 45 mm}\n"
                       "  - {name: rod, length: 3660 mm, diameter: 39 mm}\n"
                       "  - {name: rod, length: 3050 mm, diameter: 38 mm}\n"
                       "  - {name: bit, length: 60 mm, diameter: 76 mm}\n"
                       "bit_rock:\n  gamma: 0.1\n  stiffness: 100 MN/m\n" +
                       rest;
            case Layout::blockString:
                break;
        }
        return "drillwave: 2\nbit_rock: {stiffness: 100 MN/m, gamma: 0.1}\ntitle: Blocks\nmaterial:\n"
               "  youngs_modulus: 210 GPa\n  density: 7850 kg/m^3\npulse:\n  shape: rectangular\n"
               "  duration: 200 us\n  impulse: 51 N s\nstring:\n- name: rod\n  length: 3 m\n"
               "  diameter: 39 mm\n- repeat: 2\n  of:\n  - {length: 200 mm, diameter: 56 mm}\n"
               "  - length: 3660 mm\n    diameter: 38 mm\n" +
               rest;
    }

    /// Returns the next `count` lines that contain a text, from there to the line end; they identify list
    /// items.
    std::vector<std::string> items(const std::string& part, std::size_t count) const {
        std::vector<std::string> found(count);
        std::size_t at = 0;
        for (std::string& item : found) {
            at = document.text.find(part, at);
            if (at == std::string::npos) break;
            const std::size_t end = document.text.find('\n', at);
            item = document.text.substr(at, end - at);
            at = end;
        }
        return found;
    }

    void touch(const std::string& part) {
        if (!part.empty()) m_touched.insert(part);
    }

    /// Changes, removes or inserts one list item; never adds one after the last.
    template <typename Item, typename Make>
    void editList(std::vector<std::string>& marks, std::mt19937_64& random, std::vector<Item>& items,
                  const Make& make) {
        const std::size_t at = random() % items.size();
        const auto place = static_cast<std::ptrdiff_t>(at);
        switch (items.size() > 1 ? random() % 3 : 2) {
            case 0:
                touch(marks[at]);
                marks[at].clear();
                items[at] = make(at);
                return;
            case 1:
                touch(marks[at]);
                marks.erase(marks.begin() + place);
                items.erase(items.begin() + place);
                return;
            default:
                marks.insert(marks.begin() + place, std::string());
                items.insert(items.begin() + place, make(at));
        }
    }

    void editOwnList(std::mt19937_64& random, double factor) {
        Scenario& scenario = document.scenario;
        const auto length = [&] { return 0.001 * static_cast<double>(200 + random() % 4000); };
        if (m_layout == Layout::points) {
            // Edits a point between the first and the last.
            std::vector<TablePoint> points(scenario.pulse.tablePoints.begin(),
                                           scenario.pulse.tablePoints.end());
            const std::size_t at = 1 + random() % (points.size() - 2);
            const auto place = static_cast<std::ptrdiff_t>(at);
            const double middle = (points[at - 1].time + points[at].time) / 2;
            const bool isInserted = points.size() < 4 || random() % 3 == 0;
            if (isInserted) {
                points.insert(points.begin() + place, {middle, 2e5 * factor});
                m_points.insert(m_points.begin() + place, std::string());
            } else {
                touch(m_points[at]);
                m_points[at].clear();
                points[at].force = 2e5 * factor;
                if (random() % 2 == 0) {
                    points.erase(points.begin() + place);
                    m_points.erase(m_points.begin() + place);
                }
            }
            scenario.pulse.tablePoints = std::move(points);
        } else if (m_layout == Layout::corners) {
            std::vector<RockCorner>& corners = scenario.bitRock.corners;
            if (random() % 3 == 0) {
                corners.push_back({corners.back().force * 1.2, corners.back().slope * factor});
                m_corners.emplace_back();
                return;
            }
            const std::size_t at = random() % corners.size();
            touch(m_corners[at]);
            m_corners[at].clear();
            if (corners.size() > 1 && random() % 2 == 0) {
                corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(at));
                m_corners.erase(m_corners.begin() + static_cast<std::ptrdiff_t>(at));
            } else {
                corners[at].slope = 0.3 * factor;
            }
        } else if (m_layout == Layout::string) {
            editList(m_parts, random, scenario.drillString.parts, [&](std::size_t) {
                StringPart part;
                part.sections = {piece("new", length(), 0.04)};
                return part;
            });
        } else {
            std::vector<Section>& sections = scenario.drillString.parts.back().sections;
            sections.insert(sections.begin() + static_cast<std::ptrdiff_t>(random() % (sections.size() + 1)),
                            piece("", length(), 0.05));
        }
    }

    Layout m_layout;
    std::set<std::string> m_touched;
    std::vector<std::string> m_points, m_corners, m_choices, m_parts;
};

}  // namespace drillwave::test
