// SPDX-License-Identifier: BSD-3-Clause
// What the plugin does in ParaView's window from its start on: titles of colour bars with units,
// and lamps that are placed for the data when they are made by a menu. Scripts are not concerned.
#ifndef pqIlluminationStart_h
#define pqIlluminationStart_h

#include <QObject>

class pqPipelineSource;

class pqIlluminationStart : public QObject
{
  Q_OBJECT

public:
  explicit pqIlluminationStart(QObject* parent = nullptr)
    : QObject(parent)
  {
  }

  void onStartup();
  void onShutdown() {}

private:
  void watchMap(pqPipelineSource* filter);
  void placeOwnLamp(pqPipelineSource* filter);
  void placeLuminaire(pqPipelineSource* source);
};

#endif
