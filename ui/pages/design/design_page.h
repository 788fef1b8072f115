// SPDX-License-Identifier: GPL-3.0-or-later
// The page Design: which choice is best over what is not known (theory §12).
#pragma once

#include "ui/job/study_job.h"
#include "ui/pages/design/design_answer.h"
#include "ui/pages/design/design_picture.h"
#include "ui/pages/study/study_page.h"

class QCPAxisRect;
class QCheckBox;
class QLabel;
class QPushButton;

namespace drillwave {

class AimRows;
class ChoiceBox;
class DesignCard;
class DesignPlot;
class PresetTicks;
class RangeRows;

class DesignPage : public StudyPage {
    Q_OBJECT

  public:
    explicit DesignPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Design"); }
    QString command() const override;
    void copyCommand() override;
    /// Takes rows of values that belong together, a table as design --draws reads it, instead of the
    /// uncertain rows, until they are removed or another document is opened. `source` names the record of
    /// them.
    void takeDraws(const QString& source, const QByteArray& table);
    void addTo(ReportStudies& studies) const override;
    /// How many studies were started.
    int studies() const { return m_study.started(); }
    const DesignPlot& designPlot() const { return *m_plot; }
    const DesignCard& card() const { return *m_card; }
    /// Returns the present answer; nullptr at first.
    const DesignAnswer* answer() const { return m_study.value(); }

  protected:
    void ask() override;
    void present() override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    /// The study of the controls, or why there is none.
    struct Wish {
        std::optional<DesignStudy> study;
        QString problem;
    };
    Wish wish() const;
    /// Draws with their table, and what they are of.
    struct GivenDraws {
        QString source;
        QByteArray table;
        Draws draws;
    };
    QWidget* makeQuestions();
    QWidget* makeDrawsLine();
    void setDraws(std::optional<GivenDraws> draws);
    QString drawsFile() const;
    QString inputProblem() const;
    void forget();
    void followScenario();
    void chooseSamples(int samples);
    void showSetup(const DesignSetup& setup);
    bool canKeepEnergy() const;
    DesignSetup setup() const;
    void keepSetup();
    void excludePresetKeys();
    void refine();
    void showRefine(const DesignAnswer& answer);
    bool choosesPresets() const;
    void takeDesign(std::uint64_t design, Qt::KeyboardModifiers modifiers);
    void draw(const DesignAnswer& answer);
    void refuse(const QString& why);
    void showHere();
    void showRuns();
    std::optional<QPointF> placeOf(const SolvedBlow& blow) const;
    ShownUnits shownUnitsOf(const Scenario& base) const;
    std::vector<ParameterValue> valuesOf(std::uint64_t design) const;
    void click(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    void loadWorst(std::size_t aim);

    RangeRows* m_uncertain = nullptr;
    RangeRows* m_choices = nullptr;
    AimRows* m_aims = nullptr;
    PresetTicks* m_presets = nullptr;
    QCheckBox* m_keepEnergy = nullptr;
    QPushButton* m_refine = nullptr;
    QWidget* m_drawsLine = nullptr;
    QLabel* m_drawsText = nullptr;
    std::optional<GivenDraws> m_draws;
    QPushButton* m_load = nullptr;  // takes over the design to change to
    ChoiceBox* m_samples = nullptr;
    DesignCard* m_card;
    DesignPlot* m_plot = nullptr;
    QString m_problem;
    QString m_headline, m_sentence;  // of what is shown
    int m_usualSamples = 0;          // those of what was asked last
    std::shared_ptr<const DesignAnswer> m_shown;
    ShownUnits m_shownUnits;
    DesignSetup m_setup;                                // set-up of the document when last shown
    bool m_isSetUp = false;                             // the controls are of the document
    std::optional<DesignStudy> m_refined;               // which may take what it needs
    StudyRunner<DesignQuestion, DesignAnswer> m_study;  // goes first: its thread works
};

}  // namespace drillwave
