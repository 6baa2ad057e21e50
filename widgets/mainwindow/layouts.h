// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QList>
#include <QObject>

class QAction;
class QMainWindow;
class QSettings;

namespace nmc {

/// The layouts of a window for its tasks: which docks are open, where they are, and how much room each has.
/// Each layout is restored as the user left it. Where a dock is at first is in one table, by its object name.
class Layouts : public QObject {
    Q_OBJECT

public:
    enum class Kind : quint8 {
        Operate,  ///< motions, with everything around them
        Tune,     ///< plots, with gains and step beside them
        Chain,    ///< modules, packets and messages
    };

    /// `window` and `settings` must outlive it.
    Layouts(QMainWindow& window, QSettings& settings);

    /// Adds a dock that is in the table.
    void add(QDockWidget& dock);
    /// In the order in which they were added.
    [[nodiscard]] const QList<QDockWidget*>& docks() const { return m_docks; }
    [[nodiscard]] QDockWidget& dock(const QString& objectName) const;

    [[nodiscard]] const QList<QAction*>& actions() const { return m_actions; }
    [[nodiscard]] Kind kind() const { return m_kind; }
    /// The key of a setting that each layout has for itself.
    [[nodiscard]] QString key(const QString& setting) const;
    /// Shows the dock, in front of those that share its place.
    void open(QDockWidget& dock);
    /// Whether a dock is open in the initial arrangement of the present layout.
    [[nodiscard]] bool opens(const QDockWidget& dock) const;

    /// Restores the layout that was chosen last, as it was left; call it once the window has its docks and
    /// its size.
    void restore();
    void save();
    /// Returns the chosen layout to its initial arrangement.
    void reset();
    /// The window, or what is left of it beside a dock, has become wider by so many pixels: where the plots
    /// are beside everything else, they get it.
    void keepColumn(int wider);

signals:
    /// The docks have been arranged already.
    void chosen(nmc::Layouts::Kind kind);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addAction(const QString& objectName, const QString& text, const QString& meaning,
                   const QKeySequence& key);
    void choose(Kind kind);
    void show();
    void arrange();
    void makeRoomFor(QDockWidget& dock);
    /// The dock is about to be opened or closed.
    void keepColumnBeside(QDockWidget& dock);
    [[nodiscard]] QDockWidget* beside(QDockWidget& dock) const;

    QMainWindow& m_window;
    QSettings& m_settings;
    QList<QDockWidget*> m_docks;
    QList<QAction*> m_actions;  ///< in the order of Kind
    Kind m_kind = Kind::Operate;
};

}  // namespace nmc
