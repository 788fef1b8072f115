// SPDX-License-Identifier: GPL-3.0-or-later
// Files that an earlier study left beside a file are known by name and content, and no others are.
#include <QTemporaryDir>
#include <QTest>

#include "core/archive/result_files.h"
#include "tests/support/files.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

using Names = std::vector<std::string>;

/// As PDF holds text.
QByteArray inUtf16(const QByteArray& text) {
    QByteArray wide;
    for (const char c : text) wide.append('\0').append(c);
    return wide;
}

}  // namespace

class TestStudyFiles : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }
    void namesFollowFromThatOfTheRows();
    void filesOfAStudyAreKnown();
    void filesOfOthersAreNot();
    void theOtherFileOfAReportIsKnown();

  private:
    void put(const char* name, const QByteArray& bytes) const { write(m_place->filePath(name), bytes); }
    std::string folder() const { return m_place->path().toStdString(); }
    std::unique_ptr<QTemporaryDir> m_place;
};

void TestStudyFiles::namesFollowFromThatOfTheRows() {
    QCOMPARE(recordName("map.csv"), std::string("map.csv.yaml"));
    QCOMPARE(contoursName("out/map.csv"), std::string("out/map_contours.csv"));
    QCOMPARE(goalName("out/curve.csv"), std::string("out/curve_goal.csv"));
    QCOMPARE(studyStem("map.txt"), std::string("map.txt"));
    QCOMPARE(studyStem(".csv"), std::string(".csv"));
}

void TestStudyFiles::filesOfAStudyAreKnown() {
    put("map.csv.yaml", "drillwave_result: 1\nversion: 1\n");
    put("map_contours.csv", "level,line,beta,gamma,cor,residual,jump_width\n");
    put("map_goal.csv", "goal,kind,direction,beta,place_error,cor,value_error,value_after\n");
    put("map.png", "\x89PNG tEXt Software Drillwave study");
    put("map.svg", "<svg><desc>Drillwave study</desc>");
    put("map.pdf", "%PDF-1.4 /Creator (" + inUtf16("Drillwave study") + ")");
    QCOMPARE(studyFilesThere(folder(), "map.csv"),
             Names({"map.csv.yaml", "map_contours.csv", "map_goal.csv", "map.png", "map.svg", "map.pdf"}));
    QCOMPARE(studyFilesThere(folder(), "other.csv"), Names());
}

// A report that has the stem of a study, a picture that somebody else drew of it, a list of contour lines.
void TestStudyFiles::filesOfOthersAreNot() {
    put("map.csv.yaml", "my: notes\n");
    put("map_contours.csv", "height,line\n");
    put("map_goal.csv", "goal,team\n");
    put("map.png", "\x89PNG tEXt Software gnuplot");
    put("map.svg", "<svg><desc>Drillwave</desc>");
    put("map.pdf", "%PDF-1.4 /Creator (" + inUtf16("Drillwave report") + ")");
    QCOMPARE(studyFilesThere(folder(), "map.csv"), Names());
}

void TestStudyFiles::theOtherFileOfAReportIsKnown() {
    put("t38.pdf", "%PDF-1.4 /Creator (" + inUtf16("Drillwave report") + ")");
    // A page that is written beside the PDF of the same blow, as nothing was there.
    QCOMPARE(reportFilesThere(folder(), "t38.html"), Names());
    put("t38.html", "<!DOCTYPE html><script type=\"application/json\" id=\"drillwave-record\">\n{}</script>");
    QCOMPARE(reportFilesThere(folder(), "t38.html"), Names{"t38.pdf"});
    QCOMPARE(reportFilesThere(folder(), "t38.pdf"), Names{"t38.html"});
    put("t38.html", "<!DOCTYPE html><p>mine");
    QCOMPARE(reportFilesThere(folder(), "t38.pdf"), Names());
}

QTEST_GUILESS_MAIN(TestStudyFiles)
#include "tst_study_files.moc"
