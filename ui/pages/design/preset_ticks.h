// SPDX-License-Identifier: GPL-3.0-or-later
// Hammers, rods and bits to choose from, as ticks in a menu for each part.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/model/preset.h"
#include "core/study/design/design_texts.h"
#include "ui/document/preset_library.h"

class QToolButton;

namespace drillwave {

class PresetTicks : public QWidget {
    Q_OBJECT

  public:
    explicit PresetTicks(QWidget* parent);

    /// Offers the parts that presets can replace in the scenario; ticks of presets that fit stay.
    void present(const Scenario& scenario);
    /// The words of the command line, a text for each part with ticks: "hammer=medium drifter,COP 1838".
    std::vector<std::string> texts() const;
    /// Ticks what the text chooses. False, and nothing changes, where it chooses no presets that are offered.
    bool tick(const std::string& text);
    void clear();
    /// The keys that the ticked presets set.
    std::vector<std::string> keys() const;
    bool hasHammers() const;
    /// Looks names up in all presets of the program and the user. Must not outlive this.
    PresetLookup lookup() const;

  signals:
    /// texts() are other ones, by the user.
    void changed();

  private:
    struct Part {
        PresetPart part = PresetPart::hammer;
        QToolButton* button = nullptr;
        std::vector<PartPreset> offered;
        std::vector<std::string> ticked;  ///< names
    };
    void offer(Part& part);
    void set(Part& part, const std::string& name, bool isTicked);
    void showNames(Part& part);

    Scenario m_scenario;
    PresetFile m_presets;  // of all files
    std::vector<Part> m_parts;
};

}  // namespace drillwave
