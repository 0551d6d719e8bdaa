#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/machine.h"
#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/bsp/tree.h"
#include "core/render/render.h"
#include "core/scene/scene.h"

namespace bspview {

struct FirstPictureParams {
  BuildParams build;  ///< of our trees, but for the builder of two of them
  int side = 512;     ///< pixels of the picture, in both directions; one sample a pixel
  int repeats = 7;
  double patience = 100.0;  ///< seconds after which a scene is not measured again
};

/// From a scene in memory to a picture.
struct FirstPictureSeconds {
  double tree = 0.0;     ///< until rays can be shot
  double picture = 0.0;  ///< from there on; with what a growing tree builds meanwhile
  double all() const { return tree + picture; }
};

/// A way to the picture.
struct FirstPicturePeer {
  std::string name;  ///< short: a key in files
  std::string what;  ///< one line for people
  bool foreign = false;
  std::function<Result<FirstPictureSeconds>(const Scene&, const RenderParams&, std::stop_token)>
      run;
};

/// A whole tree by `sah` and by `sah-binned`, and a tree that grows.
std::vector<FirstPicturePeer> own_first_pictures(const BuildParams& params);

/// Embree's tree of boxes with our shading. None where the build found no libembree-dev.
std::vector<FirstPicturePeer> embree_first_pictures();

struct FirstPictureTimes {
  std::string name;
  std::size_t objects = 0;
  std::vector<std::vector<FirstPictureSeconds>> peers;  ///< by peer, then by repeat
};

struct FirstPictureReport {
  FirstPictureParams params;
  std::vector<FirstPicturePeer> peers;  ///< the first is what the others are compared with
  std::vector<FirstPictureTimes> scenes;
  Machine machine = this_machine();
};

/// Times the peers in turns. watch.progress adds up to 1.
Result<FirstPictureReport> run_first_picture(std::span<const Scene> scenes,
                                             const FirstPictureParams& params,
                                             const Watch& watch = {});

/// Time of the first peer over that of another: median over the repeats.
double first_picture_ratio(const FirstPictureTimes& times, std::size_t peer);

/// Table for the terminal, one object, one line a scene and peer.
std::string to_text(const FirstPictureReport& report);
std::string to_json(const FirstPictureReport& report);
std::string to_csv(const FirstPictureReport& report);

}  // namespace bspview
