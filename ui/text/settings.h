// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that the window stores for later sessions.
#pragma once

#include <QSettings>

namespace drillwave {

/// Settings of the program, stored between sessions. Their place does not depend on the application's name in
/// Qt.
class Settings : public QSettings {
  public:
    Settings()
        : QSettings(QSettings::defaultFormat(), QSettings::UserScope, QStringLiteral("drillwave"),
                    QStringLiteral("drillwave")) {}
};

inline const QString recentFilesKey = QStringLiteral("recentFiles");
inline const QString presetFilesKey = QStringLiteral("presets/files");

/// Deletes layout, page, units and all other stored choices, except the names of recent files and of added
/// files of presets.
inline void resetSettings() {
    Settings settings;
    for (const QString& key : settings.allKeys())
        if (key != recentFilesKey && key != presetFilesKey) settings.remove(key);
}

}  // namespace drillwave
