// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that the window remembers from run to run.
#pragma once

#include <QSettings>

namespace drillwave {

/// The program's settings whatever the application calls itself.
class Settings : public QSettings {
  public:
    Settings()
        : QSettings(QSettings::defaultFormat(), QSettings::UserScope, QStringLiteral("drillwave"),
                    QStringLiteral("drillwave")) {}
};

inline const QString recentFilesKey = QStringLiteral("recentFiles");
inline const QString presetFilesKey = QStringLiteral("presets/files");

/// Forgets layout, page, units and every other choice, so that the next window is as new. The names of
/// recent files and of added files of presets stay.
inline void resetSettings() {
    Settings settings;
    for (const QString& key : settings.allKeys())
        if (key != recentFilesKey && key != presetFilesKey) settings.remove(key);
}

}  // namespace drillwave
