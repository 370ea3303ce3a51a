-- SPDX-License-Identifier: Apache-2.0
-- Circle-100 from LuaJIT. usage: luajit circle.lua DECLARATIONS LIBRARY HASH
-- DECLARATIONS: what the preprocessor makes of avo.h; HASH: that of the run in C++.
local ffi = require("ffi")
local file = assert(io.open(arg[1]))
ffi.cdef(file:read("*a"))
file:close()
local avo = ffi.load(arg[2])

local function require_ok(result)
  if result ~= avo.AVO_OK then error(ffi.string(avo.avo_last_error()), 2) end
end

-- both languages have the same layouts
for name, def in pairs({
  avo_robot_def = avo.avo_default_robot_def(),
  avo_simulation_def = avo.avo_default_simulation_def(),
  avo_moving_obstacle_def = avo.avo_default_moving_obstacle_def(),
  avo_obstacle_def = avo.avo_default_obstacle_def(),
  avo_planner_def = avo.avo_default_planner_def(0),
  avo_robot = avo.avo_default_robot(),
  avo_neighbor = avo.avo_default_neighbor(),
  avo_summary = avo.avo_default_summary(),
}) do
  assert(tonumber(def.size) == ffi.sizeof(name), name)
end

local scene, simulation = ffi.new("avo_scene_id[1]"), ffi.new("avo_simulation_id[1]")
local def = ffi.new("avo_simulation_def[1]", avo.avo_default_simulation_def())
assert(avo.avo_load_scene("circle-zero", nil, 0, scene) == avo.AVO_ERROR_FILE)
assert(ffi.string(avo.avo_last_error()):find("circle%-zero"))
require_ok(avo.avo_load_scene("circle-100", nil, 0, scene))
require_ok(avo.avo_scene_get_def(scene[0], def))
require_ok(avo.avo_create_simulation(def, simulation))

local goes_on, hash = ffi.new("bool[1]", true), ffi.new("uint64_t[1]")
while goes_on[0] do
  require_ok(avo.avo_simulation_step(simulation[0]))
  require_ok(avo.avo_simulation_can_step_by(simulation[0], def[0].duration, goes_on))
end

local columns, arrived = ffi.new("avo_columns[1]"), 0
require_ok(avo.avo_simulation_columns(simulation[0], columns))
for k = 0, tonumber(columns[0].count) - 1 do
  assert(columns[0].id[k].value == k + 1)
  local p, goal = columns[0].position[k], columns[0].goal[k]
  if (p.x - goal.x) ^ 2 + (p.y - goal.y) ^ 2 <= def[0].arrival_distance ^ 2 then
    arrived = arrived + 1
  end
end
require_ok(avo.avo_simulation_get_state_hash(simulation[0], hash))
local text = ("0x%08x%08x"):format(tonumber(hash[0] / 2 ^ 32ULL), tonumber(hash[0] % 2 ^ 32ULL))
print(("%d arrived, state hash %s"):format(arrived, text))
assert(arrived == 100 and text == arg[3], "must be " .. arg[3])
require_ok(avo.avo_destroy_simulation(simulation[0]))
assert(avo.avo_simulation_step(simulation[0]) == avo.AVO_ERROR_INVALID_ID)
