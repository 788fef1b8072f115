// SPDX-License-Identifier: GPL-3.0-or-later
// Fixture with only the page Curve, its document and its own settings.
#pragma once

#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/page_words.h"
#include "tests/support/window.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/plot/figure_frame.h"

namespace drillwave::test {

/// Returns the solved blow of a document's scenario, without data of a page.
inline SolvedBlowPtr solved(const Document& document, UnitSystem units) {
    MethodSolver solver;
    SolveRequest request;
    request.scenario = document.scenario();
    request.units = units;
    return solveBlow(request, solver);
}

inline SolvedBlowPtr solved(const Document& document) {
    return solved(document, naturalUnits(document.scenario()));
}

/// The panel of the figure on show; an empty one where the page has words instead.
inline StudyPanel panelOf(const CurvePage& page) {
    return page.figure() ? page.figure()->panels.front() : StudyPanel();
}

/// The graphs of the curves that a click takes, in the order of the figure.
inline QVector<QCPGraph*> graphsOf(const CurvePage& page) {
    QVector<QCPGraph*> graphs;
    const StudyPanel panel = panelOf(page);
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        if (panel.series[i].target) graphs.append(page.figureFrame().graph(0, i));
    return graphs;
}

class CurvePageFixture {
  protected:
    CurvePageFixture() {
        keepSettingsIn(m_settings.path());
        qputenv("XDG_CONFIG_HOME", m_settings.path().toUtf8());
        QLocale::setDefault(QLocale::c());
    }
    /// Makes a page with the default scenario, not yet visible.
    void start() {
        m_page.reset();
        m_document = std::make_unique<Document>();
        m_document->start();
        m_page = std::make_unique<CurvePage>(*m_document);
        m_page->resize(900, 700);
    }
    void open(const char* text) { QCOMPARE(m_document->startFrom(text, QStringLiteral("test")), QString()); }
    void openElastic() {
        open(
            "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 1, tau: 10, delta: 0}\n"
            "pulse: {shape: rectangular}\n");
    }
    /// Shows the page with results in these units, and waits until its curve is computed.
    void showIn(UnitSystem units) {
        m_page->setResult(solved(*m_document, units));
        m_page->show();
        finish();
    }
    void finish() { QTRY_COMPARE_WITH_TIMEOUT(m_page->activity()->state(), StudyState::finished, 60000); }
    QString words() const { return pageWords(*m_page); }

    QTemporaryDir m_settings;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<CurvePage> m_page;
};

}  // namespace drillwave::test
