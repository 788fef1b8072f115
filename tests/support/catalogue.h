// SPDX-License-Identifier: GPL-3.0-or-later
// Reading the translation catalogues in resources/languages.
#pragma once

#include <QFile>
#include <QMap>
#include <QXmlStreamReader>

namespace drillwave::test {

struct CatalogueEntry {
    QString translation;
    bool isFinished = false;
    auto operator<=>(const CatalogueEntry&) const = default;
};

/// Key of a translation: its context and its English source text.
using CatalogueKey = std::pair<QString, QString>;
using CatalogueEntries = QMap<CatalogueKey, CatalogueEntry>;

/// Returns all translations of a catalogue; empty if the file does not exist.
inline CatalogueEntries readCatalogue(const QString& path) {
    CatalogueEntries entries;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return entries;
    QXmlStreamReader xml(&file);
    QString context, source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() == QLatin1String("source")) source = xml.readElementText();
        if (xml.name() != QLatin1String("translation")) continue;
        const bool isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
        entries[{context, source}] = {xml.readElementText(QXmlStreamReader::IncludeChildElements),
                                      isFinished};
    }
    return entries;
}

/// Returns the path of the catalogue of a language, given by its code, "de".
inline QString cataloguePath(const QString& code) {
    return QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/languages/drillwave_%1.ts").arg(code);
}

}  // namespace drillwave::test
