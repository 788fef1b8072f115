// SPDX-License-Identifier: GPL-3.0-or-later
// Presets offered by the window: the built-in ones and those of the user's files.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "core/model/preset.h"

namespace drillwave {

/// Presets of one file, or the built-in ones.
struct PresetSource {
    QString path;  ///< path of the file; empty for the built-in presets
    std::vector<Preset> presets;
    std::vector<SectionPreset> sectionPresets;
    QString problem;  ///< why the file is not used, line by line; empty if it is used
};

class PresetLibrary {
  public:
    PresetLibrary() { reload(); }

    /// Reads the user's files again: presets.yaml in folder(), if it exists, and the files added with add().
    void reload();
    /// Returns all sources of presets; the first one is always the built-in presets.
    const std::vector<PresetSource>& sources() const { return m_sources; }
    /// Returns the first preset of a kind whose values are those of the scenario, or nullptr.
    const Preset* matching(PresetKind kind, const Scenario& scenario) const;

    /// Adds a file of presets for this and later runs of the program. Returns the reasons if it cannot be
    /// used, one per line, else an empty text.
    QString add(const QString& path);
    /// Returns true if the file was added with add(), so that it can be removed.
    bool wasAdded(const QString& path) const;
    /// Removes a file that was added from the sources; the file itself is not deleted.
    void remove(const QString& path);

    /// Returns the folder of the user's own presets.yaml; it need not exist.
    static QString folder();

  private:
    std::vector<PresetSource> m_sources;
};

}  // namespace drillwave
