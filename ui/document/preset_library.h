// SPDX-License-Identifier: GPL-3.0-or-later
// The presets on offer: those built in and those of the user's files.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "core/model/preset.h"

namespace drillwave {

/// One file of presets, or the built-in ones.
struct PresetSource {
    QString path;  ///< empty for those built in
    std::vector<Preset> presets;
    std::vector<SectionPreset> sectionPresets;
    QString problem;  ///< why the file is not used, line by line; empty when it is
};

class PresetLibrary {
  public:
    PresetLibrary() { reload(); }

    /// Reads the user's files again: presets.yaml in folder(), if there is one, and those added.
    void reload();
    /// The built-in presets first; they are always there.
    const std::vector<PresetSource>& sources() const { return m_sources; }
    /// The first preset of a kind that matches the scenario, or nullptr.
    const Preset* matching(PresetKind kind, const Scenario& scenario) const;

    /// Uses a file from now on, in later runs too. Returns why not, line by line; then it is not used.
    QString add(const QString& path);
    /// Whether the file was added, and so can be removed.
    bool wasAdded(const QString& path) const;
    /// No longer uses a file that was added. The file stays.
    void remove(const QString& path);

    /// The folder of the user's presets.yaml; it need not exist.
    static QString folder();

  private:
    std::vector<PresetSource> m_sources;
};

}  // namespace drillwave
