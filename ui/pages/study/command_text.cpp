// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/command_text.h"

#include <QDir>
#include <QRegularExpression>

#include "core/archive/result_scenario.h"

namespace drillwave {

QString shellWord(const QString& word) {
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_./:=,@%+-]+$"));
    if (plain.match(word).hasMatch()) return word;
    QString quoted = word;
    return QLatin1Char('\'') + quoted.replace(QLatin1Char('\''), QLatin1String("'\\''")) + QLatin1Char('\'');
}

QString commandText(const Document& document, const QString& name, const QStringList& words) {
    const bool isSaved = !document.path().isEmpty() && !document.isScenarioModified();
    QStringList line{QStringLiteral("drillwave"), name,
                     isSaved ? shellWord(QDir::toNativeSeparators(document.path())) : QStringLiteral("-")};
    for (const QString& word : words) line << shellWord(word);
    const QString command = line.join(QLatin1Char(' '));
    if (isSaved) return command;
    QString scenario = QString::fromStdString(completeScenarioText(document.contents()));
    if (!scenario.endsWith(QLatin1Char('\n'))) scenario += QLatin1Char('\n');
    QString end = QStringLiteral("END");
    while (scenario.split(QLatin1Char('\n')).contains(end)) end += QLatin1Char('_');
    return command + QStringLiteral(" <<'%1'\n").arg(end) + scenario + end + QLatin1Char('\n');
}

}  // namespace drillwave
