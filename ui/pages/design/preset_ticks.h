// SPDX-License-Identifier: GPL-3.0-or-later
// Hammers, rods and bits to compare as designs: a menu of presets with tick boxes for each part.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/model/preset.h"
#include "core/study/design/design_texts.h"
#include "ui/document/preset_library.h"

class QToolButton;

namespace drillwave {

/// Menus in which the user ticks the presets to be compared as designs.
class PresetTicks : public QWidget {
    Q_OBJECT

  public:
    explicit PresetTicks(QWidget* parent);

    /// Lists the presets that can replace the hammer, the rod or the bit of the scenario. Ticks of presets
    /// that still fit are kept.
    void present(const Scenario& scenario);
    /// Returns the ticked presets as arguments of the command line, one text for each part: "hammer=medium
    /// drifter,COP 1838".
    std::vector<std::string> texts() const;
    /// Ticks the presets named in `text`, such as "hammer=medium drifter,COP 1838". Returns false and changes
    /// nothing if one of them is not offered.
    bool tick(const std::string& text);
    /// Removes all ticks; emits no changed().
    void clear();
    /// Returns the keys of all parameters whose values the ticked presets set.
    std::vector<std::string> keys() const;
    /// Returns whether a hammer is ticked.
    bool hasHammers() const;
    /// Returns a function that finds a preset by its name, among those of the program and of the user. The
    /// function must not outlive this object.
    PresetLookup lookup() const;

  signals:
    /// Reports that the user has ticked or unticked a preset.
    void changed();

  private:
    struct Part {
        PresetPart part = PresetPart::hammer;
        QToolButton* button = nullptr;
        std::vector<PartPreset> offered;
        std::vector<std::string> ticked;  ///< names of the ticked presets
    };
    void offer(Part& part);
    void set(Part& part, const std::string& name, bool isTicked);
    void showNames(Part& part);

    Scenario m_scenario;
    PresetFile m_presets;  // presets of all files
    std::vector<Part> m_parts;
};

}  // namespace drillwave
