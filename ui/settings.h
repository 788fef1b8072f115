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

}  // namespace drillwave
