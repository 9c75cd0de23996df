// SPDX-License-Identifier: BSD-3-Clause
// EndingProcess LIBRARY WAY: traces with the filter of LateFilter and ends as WAY says.
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <dlfcn.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <utility>

namespace
{

/// What a program may keep until its static objects are destroyed.
struct Keeper
{
  ~Keeper()
  {
    if (this->RunAtEnd)
    {
      this->Filter->Modified();
      this->Filter->Update(); // gets an error message, and that is all
    }
  }

  vtkSmartPointer<vtkAlgorithm> Filter;
  bool RunAtEnd = false;
};
Keeper Global;

void ExitWithFive(vtkObject*, unsigned long, void* seen, void*)
{
  if (++*static_cast<int*>(seen) == 4) // while photons are traced
  {
    std::exit(5);
  }
}

int End(const std::string& way, vtkSmartPointer<vtkAlgorithm> filter)
{
  if (way == "global" || way == "run-at-end" || way == "exit" || way == "quick_exit")
  {
    Global.Filter = std::move(filter);
    Global.RunAtEnd = way == "run-at-end";
  }
  if (way == "exit")
  {
    std::exit(4);
  }
  if (way == "exit-in-thread")
  {
    Global.Filter = std::move(filter);
    std::thread([] { std::exit(8); }).join();
  }
  if (way == "quick_exit")
  {
    std::quick_exit(7);
  }
  if (way == "leak")
  {
    filter->Register(nullptr);
    return 6;
  }
  if (way == "collector")
  {
    vtkSmartPointer<vtkAlgorithm> after = filter; // only the collector's references are left
    vtkObjectBase* held = filter;
    held->Register(nullptr);
    filter = nullptr;
    after = nullptr;
    held->UnRegister(nullptr);
  }
  if (way == "terminate")
  {
    std::raise(SIGTERM);
  }
  return way == "return" ? 3 : 0;
}

} // namespace

int main(int, char* words[])
{
  void* library = dlopen(words[1], RTLD_NOW);
  if (!library)
  {
    std::cerr << dlerror() << "\n";
    return 99;
  }
  const auto make = reinterpret_cast<vtkAlgorithm* (*)(long long)>(dlsym(library, "MakeFilter"));
  const std::string way = words[2];
  const bool whileTracing = way == "exit-while-tracing";
  auto filter = vtk::TakeSmartPointer(make(whileTracing ? 4000000000LL : 20000LL));
  if (whileTracing)
  {
    int seen = 0;
    vtkNew<vtkCallbackCommand> watch;
    watch->SetCallback(ExitWithFive);
    watch->SetClientData(&seen);
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    Global.Filter = filter;
    filter->Update();
    return 98;
  }
  filter->Update();
  return End(way, std::move(filter));
}
