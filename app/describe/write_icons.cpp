// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the icon of the program in every width as a theme of icons has them, for the build: drillwave-icons
// FOLDER
#include <QDir>
#include <QString>
#include <cstdio>

#include "ui/window/program_icon.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: drillwave-icons FOLDER\n", stderr);
        return 2;
    }
    for (const int width : drillwave::iconWidths) {
        const QString folder = QString::fromLocal8Bit(argv[1]) + QStringLiteral("/%1x%1/apps").arg(width);
        const QString path = folder + "/drillwave.png";
        if (!QDir().mkpath(folder) || !drillwave::programImage(width).save(path)) {
            std::fprintf(stderr, "%s cannot be written\n", qPrintable(path));
            return 1;
        }
    }
    return 0;
}
