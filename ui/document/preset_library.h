// SPDX-License-Identifier: GPL-3.0-or-later
// Presets offered by the window: the built-in ones and those of the user's files.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "core/model/preset.h"

namespace drillwave {

/// Presets (named sets of values for a rod, hammer, rock or section) of one file, or the built-in ones.
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
    /// Returns all sources of presets (files and the built-in presets); the first one is always the built-in
    /// presets.
    const std::vector<PresetSource>& sources() const { return m_sources; }
    /// Returns the first preset of this kind whose values are all the same as in the scenario; nullptr if
    /// there is none.
    const Preset* matching(PresetKind kind, const Scenario& scenario) const;

    /// Adds a file of presets for this and later runs of the program. Returns the reasons if it cannot be
    /// used, one per line, else an empty text.
    QString add(const QString& path);
    /// Returns true if the file was added with add(), and can be removed with remove().
    bool wasAdded(const QString& path) const;
    /// Removes a file, added with add(), from the sources of presets. The file itself is not deleted.
    void remove(const QString& path);

    /// Returns the folder of presets.yaml, the file of the user's own presets. The folder need not exist.
    static QString folder();

  private:
    std::vector<PresetSource> m_sources;
};

}  // namespace drillwave
