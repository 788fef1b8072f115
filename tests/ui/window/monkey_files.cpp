// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/monkey_files.h"

#include <QDir>
#include <QFile>

#include "core/yaml/examples.h"

namespace drillwave {
namespace {

const QByteArray pulseTable = "time [us],force [kN]\n0,0\n20,180\n60,240\n120,210\n180,40\n200,0\n";

// Two strain gauges, with decimal commas and an empty cell.
const QByteArray gaugeTable =
    "Zeit [ms];oben [µm/m];unten [µm/m]\n0,0;2,1;-1\n0,1;-950,5;-970\n0,2;-800,25;\n0,3;-3;4\n0,4;90;85\n";

QByteArray textOf(const char* example) {
    const Example* found = findExample(example);
    return found ? QByteArray::fromStdString(std::string(found->text)) : QByteArray();
}

}  // namespace

MonkeyFiles::MonkeyFiles() {
    for (const char* name :
         {"rod.yaml", "string.yaml", "groups.yaml", "broken.yaml", "invalid.yaml", "noise.yaml", "empty.yaml",
          "pulse.csv", "ragged.csv", "missing.yaml", "folder", "notes.txt", "gauges.txt", "histories.csv"})
        m_toOpen.append(path(QLatin1String(name)));
    for (const char* name :
         {"rod.yaml", "new.yaml", "other.yml", "without_suffix", "missing/new.yaml", "folder"})
        m_toSave.append(path(QLatin1String(name)));
    for (const char* name : {"out", "histories.csv", "picture.png", "missing/picture.svg", "folder"})
        m_toExport.append(path(QLatin1String(name)));
    writeAll();
}

void MonkeyFiles::writeAll() {
    QDir(m_folder.path()).mkdir(QStringLiteral("folder"));
    write(QStringLiteral("rod.yaml"), textOf("t38_medium_rock"));
    write(QStringLiteral("string.yaml"), textOf("t38_string"));
    write(QStringLiteral("groups.yaml"), textOf("paper_fig4b"));
    write(QStringLiteral("broken.yaml"), "drillwave: 1\nrod: [3\n");
    write(QStringLiteral("invalid.yaml"), "drillwave: 1\ngroups: {beta: -1}\n");
    write(QStringLiteral("noise.yaml"), QByteArray("\x00\xff\xfe\x01\x02yaml: \x80", 12));
    write(QStringLiteral("empty.yaml"), {});
    write(QStringLiteral("pulse.csv"), pulseTable);
    write(QStringLiteral("ragged.csv"), "time [us],force [kN]\n0,0\n20\n");
    write(QStringLiteral("notes.txt"), "not a scenario\n");
    write(QStringLiteral("gauges.txt"), gaugeTable);
}

void MonkeyFiles::write(const QString& name, const QByteArray& bytes) {
    QFile file(path(name));
    if (file.open(QIODevice::WriteOnly)) file.write(bytes);
}

void MonkeyFiles::change(int choice) {
    const QString rod = QStringLiteral("rod.yaml");
    switch (choice % 5) {
        case 0:
            return writeAll();
        case 1:
            return write(rod, textOf("r32_hard_rock"));
        case 2:
            return write(rod, "drillwave: 1\nrodd: 3\n");
        case 3:
            QFile::remove(path(rod));
            return;
        default:
            return write(QStringLiteral("pulse.csv"), choice % 2 ? pulseTable : QByteArray("time\n"));
    }
}

}  // namespace drillwave
