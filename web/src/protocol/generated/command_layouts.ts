// Made by schema/generate.mjs from schema/definitions.txt and commands.txt: change these, not this file.
// prettier-ignore
/** The fields of definitions: name, type and default (codec.ts). */
export const kDefinitionLayouts: Readonly<Record<string, string>> = {
  Vec2: '0:f64 1:f64',
  PolygonWithHoles: 'outline:Vec2* holes:Vec2**',
  FormationDef: 'kind:FormationKind=square spacing:f64=1 opening:f64=1.2 outline:PolygonWithHoles points:Vec2* files:i32',
  Distribution: 'spread:Spread=constant a:f64 b:f64 least:f64 most:f64=1e9',
  PeopleDef: 'name:text share:f64=1 unitClass:u8 speed:Distribution radius:Distribution headway:Distribution premovement:Distribution age:Distribution upstairs:f64 downstairs:f64',
  Conduct: 'stance:Stance=normal cohesion:f64 squeeze:f64=1 avoids:bool',
  RoleDef: 'area:RoleArea=front unitClass:u8=1',
  GroupColour: 'colour:u32?',
  GroupLook: 'build:BodyBuild? motions:MotionSet?',
  Body: 'radius:f64 maxSpeed:f64 acceleration:f64 mass:f64=1 supply:f64=1 unitClass:u8 headway:f64 premovement:f64 upstairs:f64 downstairs:f64',
  Waypoint: 'time:f64 position:Vec2 angle:f64',
  TimedPath: 'waypoints:Waypoint* loop:bool',
  Order: 'kind:OrderKind=move target:Vec2 facing:f64? width:f64 route:Vec2* formation:FormationDef? manner:Manner=march turn:Turn=flow pace:f64 share:f64=0.95 group:u32 character:u32 offset:Vec2 halfSize:Vec2 path:TimedPath exits:u32* choice:ExitChoice=quickest attractions:f64* herding:f64 misjudgement:f64 area:u32 seconds:f64',
  GroupDef: 'name:text=Group count:i32=36 formation:FormationDef position:Vec2 angle:f64 starts:Vec2* jitter:f64 bodies:Body* roles:RoleDef* demands:f64* conduct:Conduct orders:Order* patrols:bool colour:u32? build:BodyBuild? motions:MotionSet? people:PeopleDef*',
  ObstacleDef: 'name:text polygon:Vec2* centre:Vec2 radius:f64 path:TimedPath range:f64=-1 strength:f64=-1 height:f64=3',
  PatchDef: 'name:text polygon:Vec2* path:TimedPath motion:i32 speed:f64=-1 ascent:f64? speedDown:f64=-1',
  ItemDef: 'position:Vec2 radius:f64=0.5',
  CheckpointDef: 'position:Vec2 radius:f64=2 formation:FormationDef group:i32=-1 once:bool=1 trigger:CheckpointTrigger=crowd share:f64=0.5',
  Arrivals: 'time:f64 count:i32',
  AreaDef: 'name:text kind:AreaKind=exit polygon:Vec2* open:bool=1 rate:f64 queue:Vec2* group:i32 from:f64 until:f64=1e9 most:i32 timetable:Arrivals*',
  QueuedOrder: 'id:u32 order:Order',
};

// prettier-ignore
/** What bytes call the kinds of commands, in the order of kCommandLayouts. */
export const kCommandNumbers: readonly number[] = [51, 4, 52, 7, 49, 10, 11, 12, 47, 48, 19, 20, 21, 23, 25, 26, 27, 50, 32, 46];

// prettier-ignore
/** Commands: kind and fields. */
export const kCommandLayouts: readonly (readonly [string, string])[] = [
  ['touch', 'phase:TouchPhase=down touch:u32 position:Vec2 time:f64 group:u32'],
  ['control', 'group:u32 control:ControlKind=point touches:u32* positions:Vec2* time:f64'],
  ['editControl', 'group:u32 control:u32 edit:ControlEdit=pin'],
  ['release', 'unused:u8'],
  ['changeGroup', 'group:u32 formation:FormationDef? count:i32? people:PeopleDef*? conduct:Conduct? roles:RoleDef*? demands:f64*? name:text? colour:GroupColour? look:GroupLook?'],
  ['pose', 'group:u32 position:Vec2 angle:f64 characters:bool'],
  ['group', 'group:GroupDef'],
  ['removeGroup', 'group:u32'],
  ['putThing', 'id:u32 obstacle:ObstacleDef? patch:PatchDef? item:ItemDef? checkpoint:CheckpointDef? area:AreaDef? group:u32'],
  ['removeThing', 'thing:ThingKind=obstacle id:u32'],
  ['parameter', 'name:text value:f64'],
  ['order', 'group:u32 mode:QueueMode=replace index:u32 order:Order'],
  ['queue', 'group:u32 edit:QueueEdit=cancel order:u32'],
  ['join', 'group:u32 positions:Vec2* bodies:Body*'],
  ['transfer', 'ids:u32* group:u32'],
  ['split', 'group:u32 by:SplitBy=ids ids:u32* points:Vec2* shares:f64* abreast:bool shape:PartShape=asHeld'],
  ['merge', 'groups:u32* shape:PartShape=smaller'],
  ['changeCharacters', 'ids:u32* bodies:Body*? driver:Driver?'],
  ['motion', 'ids:u32* positions:Vec2* velocities:Vec2*'],
  ['reverseQueue', 'group:u32'],
];
