// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in an SVG picture.
#pragma once

#include <QStringList>
#include <QXmlStreamReader>

namespace drillwave::test {

/// Returns the texts of an SVG picture, each including subscripts and superscripts; empty if the picture is
/// not valid XML.
inline QStringList svgTexts(const QByteArray& svg) {
    QXmlStreamReader xml(svg);
    QStringList texts;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1StringView("text"))
            texts << xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
    return xml.hasError() ? QStringList() : texts;
}

}  // namespace drillwave::test
