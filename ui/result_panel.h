// The numbers of a solved blow, what happened at the bit, and what to know about it.
#pragma once

#include <QLabel>
#include <QList>
#include <QScrollArea>

#include "ui/alert_list.h"
#include "ui/event_model.h"
#include "ui/section_box.h"
#include "ui/solved_blow.h"

class QTableView;

namespace drillwave {

class ResultPanel : public QScrollArea {
    Q_OBJECT

  public:
    explicit ResultPanel(QWidget* parent = nullptr);

    void show(const SolvedBlowPtr& blow);

    AlertList* alerts() const { return m_alerts; }
    QSize sizeHint() const override;
    /// Wide enough that nothing is cut off at the side.
    QSize minimumSizeHint() const override;

  signals:
    /// The user chose an event: its global time t/t0.
    void timeChosen(std::optional<double> time);

  private:
    /// How one number of a blow is written; empty where it is not given.
    using Text = QString (*)(const SolvedBlow&);
    struct Row {
        SectionBox* section;
        QLabel* name;
        QLabel* value;
        Text text;
    };
    struct Entry {
        QString name;
        QString meaning;
        Text text;
    };

    SectionBox* addSection(const QString& title);
    void addNumbers(const QString& title, const QList<Entry>& entries);
    void addHeadline();
    void addEvents();

    QLabel* m_cor = nullptr;
    QLabel* m_error = nullptr;
    QList<Row> m_rows;
    EventModel* m_eventModel;
    QTableView* m_events = nullptr;
    AlertList* m_alerts = nullptr;
};

}  // namespace drillwave
