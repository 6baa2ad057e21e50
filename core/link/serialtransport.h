// SPDX-License-Identifier: MIT
#pragma once

#include <QSerialPort>
#include <QString>

#include "link/transport.h"

namespace nmc {

/// A serial port through QSerialPort, 8N1, no flow control. Nobody else may use the port meanwhile: besides
/// Qt's lock file, which goes by name, the descriptor is locked with flock, which catches other names for it
/// and root.
class SerialTransport : public Transport {
public:
    explicit SerialTransport(QString port);
    ~SerialTransport() override;

    tl::expected<void, PortError> open() override;
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override;
    tl::expected<void, PortError> send(ByteSpan bytes) override;
    void discardInput() override;
    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override;
    [[nodiscard]] int fd() const override { return m_port.handle(); }

private:
    [[nodiscard]] PortError openError() const;
    [[nodiscard]] PortError gone() const;

    QString m_name;
    QSerialPort m_port;
};

}  // namespace nmc
