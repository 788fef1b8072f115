// Where the window keeps what it remembers from run to run.
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

/// Forgets layout, page, units and every other choice, so that the next window is as new. The names of
/// recent files stay.
inline void resetSettings() {
    Settings settings;
    for (const QString& key : settings.allKeys())
        if (key != recentFilesKey) settings.remove(key);
}

}  // namespace drillwave
