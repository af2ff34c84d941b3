// SPDX-License-Identifier: Apache-2.0
// pipegs_pkg: widths, counts, capacities, records and registers of the machine. Printed by
// cpp_model/package_sv.cpp from config.def, records.def and control/registers.def of cpp_model (`make package`):
// change those, never this file.
//
// Configuration: fronts=2,window=128,group=16,late=1,order=2,quads=1,pos_w=18,base_w=14,mantissa_w=22,coeff_f=24,tight_cull=1,tight_boxes=1,occlusion=1,tests=2,pace=4,alpha_w=10,pixel_w=32,records=1408,bucket_bits=7,nearest_nodes=1024,mark_chunks=7,taps=0.   Model  cpp_model/config.hpp, cpp_model/records.hpp
// Fixed point is written sI.F / uI.F; the first field of a record lies in its low bits.

package pipegs_pkg;

  localparam int unsigned Units          = 4;  // PUs, SUs and RUs (1, 2, 4 or 8), Table 2
  localparam int unsigned Fronts         = 2;  // PUs that fetch and cull, at most all; every PU projects (1, 2, 4 or 8)
  localparam int unsigned PixelsPerRow   = 2;  // pixels that one Row Unit computes in a cycle
  // side of a window (16, 32, 64 or 128); regions are 8x8 pixels, a window of 128 has four parts of 64
  localparam int unsigned Window         = 128;
  // cameras side by side whose pictures one walk of a window makes: 1 or 2 (2 needs quads, pixel_w = 32)
  localparam int unsigned Eyes           = 1;
  localparam int unsigned Grid           = 4;  // cells of the orthogonal grid along one axis; 4 outdoor, 8 indoor
  localparam int unsigned Chunk          = 16;  // most Gaussians in one chunk
  localparam int unsigned Group          = 16;  // most chunks in one group, the node between a cell and its chunks
  localparam int unsigned ShDegree       = 3;  // highest SH degree that the colour hardware evaluates
  // 0: the PUs compute alphas and a store caches them; 1: coefficients are cached, the Row Units stand in the RUs
  localparam int unsigned Late           = 1;
  // 0: layers (DOP); 1: global preprocessing into lists of the windows; 2: nearest chunk first, released by watermarks
  localparam int unsigned Order          = 2;
  // 1: every pixel's power by the full quadratic form instead of differences (needs late)
  localparam int unsigned Quadratic      = 0;
  // 1: of a region the lanes blend only the quads of 2x2 pixels that a splat changes; 0: whole regions (1 needs late,
  // and quadratic = 0)
  localparam int unsigned Quads          = 1;
  // a Gaussian in memory, its geometry and its SH of degree 3: 96, each as below; 48: codes (code_t) that pu_decode and
  // pu_color_sum turn into those
  localparam int unsigned Record         = 96;
  localparam int unsigned WorldW         = 40;  // world coordinate, signed, unit 2^scene_exponent
  // offset of a mean from its chunk's centre, signed, unit 2^offset_exp world units
  localparam int unsigned PosW           = 18;
  localparam int unsigned QuatW          = 16;  // quaternion component, s0.(QuatW-1)
  localparam int unsigned ScaleMW        = 12;  // mantissa of a scale below its leading one
  localparam int unsigned ScaleEW        = 6;  // exponent of a scale; 0 is scale zero
  localparam int unsigned OpacityF       = 12;  // fraction of -log2(opacity), u4.F
  localparam int unsigned BaseW          = 14;  // SH band 0 plus one half, s2.(BaseW-3)
  localparam int unsigned ShMW           = 11;  // mantissa of an SH coefficient of band 1 to 3, signed
  localparam int unsigned ShEW           = 5;  // exponent that the SH coefficients of one Gaussian share
  localparam int unsigned IndexW         = 24;  // index of a Gaussian in its scene file, breaks ties in depth
  localparam int unsigned ViewW          = 28;  // view-space coordinate, signed, unit 2^view_exp world units
  localparam int unsigned DepthW         = 24;  // depth key: 6 exponent bits, then mantissa
  localparam int unsigned TanF           = 22;  // fraction of x/z and y/z, s4.F
  localparam int unsigned MeanF          = 12;  // fraction of a projected mean, s18.F pixel
  // 1: the PUs can lower a Gaussian's opacity by what the dilation adds to its area, for scenes trained so
  localparam int unsigned Antialias      = 0;
  localparam int unsigned MantissaW      = 22;  // normalised mantissas of the projection, leading one included
  localparam int unsigned CoeffF         = 24;  // fraction of the power coefficients A to F, log2 units
  localparam int unsigned PowerF         = 20;  // fraction of the Row Units' accumulators, log2 units
  localparam int unsigned AlphaCut       = 255;  // a pixel counts iff alpha >= 1/AlphaCut
  // 1: the regions of a Gaussian's box that hold a pixel that counts; 0: all regions of the box; 2: those that the
  // oriented box of three standard deviations touches, which loses what lies beyond (GSCore)
  localparam int unsigned TileTest       = 1;
  // 1: a Gaussian is also dropped when its own ellipse ends before the window; 0: only when its largest scale does (1
  // needs order 0 or 2)
  localparam int unsigned TightCull      = 1;
  // 1: a node holds the box around its Gaussians' ellipsoids, too, which the DOPU tests where they are small beside
  // their distance; 0: only that of their means, grown by the largest scale (1 needs order 2)
  localparam int unsigned TightBoxes     = 1;
  // 1: a group has proxies, which a frame may take in place of its Gaussians where they are small; 0: it has none (1
  // needs order = 2)
  localparam int unsigned Lod            = 0;
  // 1: what lies beside a rectangle around the regions still open is neither fetched nor projected; 0: it is, until the
  // whole walk is closed (1 needs order = 2)
  localparam int unsigned Occlusion      = 1;
  localparam int unsigned Tests          = 2;  // regions side by side that pu_intersect tests in a cycle
  localparam int unsigned Pace           = 4;  // for which a stage of the projection keeps a Gaussian: 8 or 4
  localparam int unsigned ExpIndexW      = 6;  // index of the exp2 table
  // 1: linear interpolation between the entries of the exp2 table; 0: the entry alone, no multiplier
  localparam int unsigned ExpLinear      = 1;
  localparam int unsigned AlphaW         = 10;  // alpha, u0.AlphaW; 0 means below 1/AlphaCut
  localparam int unsigned ColorW         = 12;  // colour of a Gaussian, u2.(ColorW-2)
  localparam int unsigned TW             = 19;  // transmittance, u1.(TW-1)
  localparam int unsigned TCut           = 10000;  // a pixel stops before its transmittance falls below 1/TCut
  localparam int unsigned RgbW           = 16;  // accumulated colour, u2.(RgbW-2)
  // pixel in the frame in memory; 64: T u1.15, blue, green, red u2.14, red lowest; 32: A2B10G10R10, a colour c is
  // round(1023 c)
  localparam int unsigned PixelW         = 32;
  localparam int unsigned AovCoverage    = 0;  // 1: transmittance, u1.15, and above it the number of Gaussians blended
  // 1: expected depth, the sum of weight * depth, u0.32 of the frame's range
  localparam int unsigned AovDepth       = 0;
  // 1: median depth, that of the Gaussian with which T falls below one half; 0: none does
  localparam int unsigned AovMedian      = 0;
  // 1: index of the Gaussian that weighs most, the nearest of equal ones; all ones: none
  localparam int unsigned AovIndex       = 0;
  localparam int unsigned AlphaLines     = 1024;  // alpha store of one unit: lines of one region's 64 alphas
  // layers that live in an alpha store at a time: with more than a window has, the PUs fill a heavy one while the RUs
  // blend that of the window before
  localparam int unsigned AlphaLayers    = 8;
  localparam int unsigned Records        = 1408;  // record store of one SU, a pool of slots
  // mantissa bits of the depth key that choose a bucket of depth: 2^n buckets an octave, in the SUs and in the DOPU
  // (order = 2)
  localparam int unsigned BucketBits     = 7;
  localparam int unsigned FetchLines     = 32;  // lines of the overflow area that one RU may have asked for
  localparam int unsigned NearestNodes   = 1024;  // nodes that wait in the DOPU, the nearest first (order = 2)
  localparam int unsigned MarkChunks     = 7;  // fewest chunks between two watermarks of a window (order = 2)
  localparam int unsigned NearTest       = 1;  // 1: what lies before the near plane is dropped; 0: nothing does
  // 1: the Jacobian's x/z, y/z are clamped to 1.3 tan(fov/2); 0: only saturated
  localparam int unsigned GuardBand      = 1;
  localparam int unsigned Saturation     = 1;  // 1: colours clip at the top; 0: they wrap
  // 1: pixels stop at 1/TCut and regions close; 0: every Gaussian is blended
  localparam int unsigned EarlyStop      = 1;
  // 1: a window is walked slab by slab, each slab a layer; 0: a window is one layer (order = 0)
  localparam int unsigned Layered        = 1;
  // 1: equal depth keys are ordered by index; 0: the depth alone is the sort key, no two are equal
  localparam int unsigned IndexTies      = 1;
  // 1: alphas, records and keys that find no room go to external memory; 0: there is always room
  localparam int unsigned Overflow       = 1;
  localparam int unsigned LargeGroups    = 1;  // 1: the SU cuts chains of more than 16 keys; 0: no bucket holds more
  // data of the AXI4 bus to memory: 128, 256 or 512; 0: the core's own port of a line, without a bus
  localparam int unsigned BusW           = 512;
  // 1: a unit's clock stops while it has nothing to do; 0: never, clk_o = clk_i, for FPGAs
  localparam int unsigned ClockGates     = 1;
  // 1: the streams show at the top level (tap_*), so every one is compared; 0: only pixels are
  localparam int unsigned Taps           = 0;
  localparam bit Coded                   = 1'b0;  // geometry and SH lie in memory as codes
  localparam bit CachesAlphas            = 1'b0;  // the PUs compute alphas; else coefficients, and the RUs alphas
  localparam bit HasLayers               = 1'b0;  // a window is sorted and blended layer by layer
  localparam bit HasLists                = 1'b0;  // the frame is preprocessed into lists of its windows in memory
  localparam bit HasWatermarks           = 1'b1;  // chunks come nearest first, watermarks release what is sorted
  localparam bit HasStores               = 1'b0;  // alpha stores lie between the PUs and the RUs
  localparam bit Oriented                = 1'b0;  // regions are those that the oriented box touches
  localparam bit SpillsAlphas            = 1'b1;  // lines of alphas may lie in external memory
  localparam int unsigned PuFronts       = 2;  // PUs that fetch and cull
  localparam int unsigned GeometryJobs   = 16;  // chunks whose lines such a PU has asked for
  // lines of geometry in flight or waiting in it: as many in all, whatever their number
  localparam int unsigned GeometryLines  = 128;
  // Gaussians from where pu_project gives a payload to pu_conic's output: one place less than all; two are in pu_conic,
  // which is no stage of the table in eight cycles
  localparam int unsigned ShapePlaces    = 19;
  // Gaussians from where pu_project gives a centre to where pu_covariance takes it: one at the output of the first,
  // none at that of the last
  localparam int unsigned CenterDepth    = 12;
  // Gaussians from where a payload is known to where pu_intersect takes them: the places before, those in pu_coeff,
  // queue
  localparam int unsigned PayloadDepth   = 20;
  // a window's cells are walked slab by slab from the camera; 0: in the order of their table
  localparam bit HasSlabs                = 1'b0;
  // entries of the table of cells: with watermarks a cell with many groups has several
  localparam int unsigned TableCells     = 256;
  localparam int unsigned Slabs          = 1;  // slabs of a window's walk
  localparam int unsigned SlabCells      = 256;  // entries of the table in a slab
  localparam int unsigned PartsX         = 2;  // squares along a window's side
  localparam int unsigned Squares        = 4;  // of a window, numbered row by row
  localparam int unsigned SquareW        = 2;  // number of a square; absent when a window has one
  localparam int unsigned EyeW           = 0;  // number of an eye; absent when there is one
  localparam int unsigned EyesW          = 0;  // one bit for each; absent likewise
  // half the distance between the eyes, signed, world units; absent likewise
  localparam int unsigned HalfEyeW       = 0;
  localparam int unsigned EyeReachW      = 0;  // the same as a scale; absent likewise
  // what a test of nodes knows of the eyes: length, y and x each a sign above its reach, of either set of planes a flag
  // and the one eye that it is for; of one eye 0
  localparam int unsigned TestEyesW      = 1;
  // what a cull knows of the eyes: which are wanted, half_y, half_x; of one eye 0
  localparam int unsigned SeenEyesW      = 4;
  localparam int unsigned EyeLengthW     = 0;  // bits of such a distance; absent likewise
  localparam int unsigned EyeAddressW    = 0;  // lines of a picture; absent likewise
  // parts of a window, a square in an eye: what masks, coefficients and powers are made for
  localparam int unsigned Parts          = 4;
  localparam int unsigned PartW          = 2;  // number of a part: its eye above its square; absent when there is one
  localparam int unsigned PartSide       = 64;  // side of a part in pixels
  localparam int unsigned PartRegionsX   = 8;  // regions along a part's side
  localparam int unsigned MaskW          = 64;  // regions of a part, bits of its mask
  localparam int unsigned MaskIndexW     = 6;  // index of a region in its part, row by row
  localparam int unsigned Regions        = 256;  // regions of a window
  localparam int unsigned RegionW        = 8;  // index of a region in its window: its part above its index in the part
  localparam int unsigned PlacesW        = 4;  // column or row of a region in its window
  // columns or rows of regions of a window, from one side, in which none is open
  localparam int unsigned ClosedW        = 4;
  localparam bit HasWalks                = 1'b1;  // a window may be walked part by part
  // of a walk of one eye: a flag and the eye; absent where there is one, or all walks are of windows
  localparam int unsigned WalkEyeW       = 0;
  // what a walk covers: 0 its window, else a flag and the one square, and below them whose eye's; absent where all are
  // of windows
  localparam int unsigned WalkW          = 3;
  localparam int unsigned EyeClosedW     = 0;  // ClosedW; absent like WalkEyeW
  localparam int unsigned WalkMostW      = 24;  // Gaussians of a walk; absent likewise
  // what a beat is: 0 data, 1 end of layer, 2 end of window (and of its last layer), 3 end of a walk of a part that is
  // not its window's last
  localparam int unsigned KindW          = 2;
  localparam int unsigned BitW           = 1;  // a flag
  // sort key: depth, then index, so equal depths are ordered by index, then the part; no index without IndexTies
  localparam int unsigned KeyW           = 50;
  localparam int unsigned RecordW        = 11;  // slot of a key or record in an SU's stores
  // octave of a bucket: the depth key's exponent; with watermarks 16 of them, from the near plane's on
  localparam int unsigned OctaveW        = 4;
  localparam int unsigned BucketW        = 11;  // bucket of depth: its octave, then leading bits of the mantissa
  // leading bits of a bucket: where in depth a window's load is counted (dopu_load)
  localparam int unsigned LoadW          = 8;
  localparam int unsigned WindowW        = 10;  // column or row of a window in the frame
  // where a beat belongs, as chunk, fetched and visible have it: its window, then its walk
  localparam int unsigned PlaceW         = 23;
  localparam int unsigned SizeW          = 15;  // width or height of the frame, pixels
  localparam int unsigned ExpW           = 6;  // block exponent, unsigned
  localparam int unsigned FloatEW        = 9;  // exponent of a normalised mantissa, signed
  localparam int unsigned SlotW          = 24;  // slot of a Gaussian, or of a proxy, in packed memory
  localparam int unsigned ChildrenW      = 16;  // groups of a cell
  localparam int unsigned ErrorW         = 0;  // error of a group's proxies; absent unless lod
  // Gaussians of a chunk, chunks of a group; of a cell's groups the lower bits
  localparam int unsigned CountW         = 16;
  localparam int unsigned ErrorBits      = 2;  // mantissa bits of such an error: four steps an octave
  localparam int unsigned ChunkProxies   = 2;  // most proxies of a chunk's Gaussians: they fill chunks of their own
  localparam int unsigned LodW           = 0;  // level of detail of a frame; absent unless lod
  // half extent of a bounding box, unsigned, unit 2^half_exp world units, rounded up
  localparam int unsigned HalfW          = 8;
  // how far the box around ellipsoids reaches, unit 2^(half_exp + 1), rounded up; absent unless tight_boxes
  localparam int unsigned HullW          = 7;
  // log2 of the standard deviations that a Gaussian reaches, and of what log2 m exceeds m - 1 by (at most 0.0861), unit
  // 1/64, rounded up
  localparam int unsigned HullLog        = 118;
  localparam int unsigned RotW           = 26;  // camera rotation matrix, s1.24
  localparam int unsigned RotF           = 24;  // its fraction
  localparam int unsigned CamQuatW       = 20;  // camera quaternion, s1.18
  localparam int unsigned FocalW         = 28;  // focal length, u14.14 pixel
  localparam int unsigned FocalF         = 14;  // its fraction
  localparam int unsigned CenterW        = 28;  // principal point, s15.12 pixel
  localparam int unsigned CenterF        = 12;  // its fraction
  // corners and plane normals of the DOPU's box test, signed, block-normalised
  localparam int unsigned TestW          = 20;
  localparam int unsigned AntialiasW     = 0;  // flag of the frame; absent unless antialias
  // leading bits of the determinant before dilation; absent unless antialias
  localparam int unsigned SharpW         = 0;
  localparam int unsigned SharpEW        = 0;  // its exponent
  localparam int unsigned ReachW         = 32;  // pixels of reach per unit of scale and 1/z, u18.14
  // square of the reach of a unit scale across the line of sight: exponent u5, then mantissa u0.8; absent unless
  // tight_cull
  localparam int unsigned SpreadW        = 13;
  // view-space coordinate in the cull, signed, cut to 17 bits of magnitude
  localparam int unsigned CutW           = 18;
  localparam int unsigned CutShiftW      = 5;  // low bits of a view-space coordinate that the cull leaves out
  // distance of a mean from its window times z, signed, 1/16 pixel cut units
  localparam int unsigned GapW           = 41;
  // scale: exponent, then mantissa; (1 + m/2^ScaleMW) * 2^(e-8) world units
  localparam int unsigned ScaleW         = 18;
  localparam int unsigned OpacityW       = 16;  // -log2(opacity), u4.OpacityF
  // step of depth: the depth key's exponent and leading bits of its mantissa; the DOPU's buckets are steps, counted
  // from the near plane's (order = 2)
  localparam int unsigned StepW          = 13;
  localparam int unsigned TanW           = 27;  // x/z, y/z
  localparam int unsigned WindowMeanW    = 31;  // projected mean relative to its window's first pixel
  // projected mean; where it is moved to another first pixel, with lists and with parts, a bit more keeps what
  // saturates in no window or part
  localparam int unsigned MeanW          = 32;
  localparam int unsigned DirectionW     = 18;  // component of the view direction, signed, block-normalised
  localparam int unsigned WorldDirectionW = 20;  // component of the view direction in world axes, s(DirectionW).1
  localparam int unsigned LengthW        = 36;  // squared length of the view direction
  localparam int unsigned UnitDirectionW = 18;  // component of the unit direction in world axes, s1.16
  localparam int unsigned UnitDirectionF = 16;  // its fraction
  localparam int unsigned BasisW         = 17;  // SH basis function, s0.16; none exceeds 0.75
  localparam int unsigned BasisF         = 16;  // its fraction
  // part of a line: the slot of a Gaussian of SH degree 1, a quarter of the line; coded an eighth
  localparam int unsigned QuarterW       = 2;
  localparam int unsigned OffsetCodeW    = 14;  // code of an offset, signed, unit 2^(PosW - 14) of the offset's
  localparam int unsigned AxisW          = 2;  // number of a component of a quaternion: w, x, y, z
  localparam int unsigned TurnCodeW      = 9;  // code of a component of a quaternion, signed, unit 2^-8 / sqrt(2)
  // code of a scale: sixteenths of an octave below 8 * 2^scale_exp; the last one is scale zero
  localparam int unsigned ScaleCodeW     = 8;
  localparam int unsigned OpacityCodeW   = 8;  // code of an opacity, u0.8 of 255
  localparam int unsigned BaseCodeW      = 8;  // code of SH band 0, s0.7
  // exponent of the largest effective scale of a chunk; absent unless coded
  localparam int unsigned ScaleExpW      = 0;
  // where a chunk's Gaussians lie: its node's centre, offset_exp, and the exponent of scale_max if coded
  localparam int unsigned NodePlaceW     = 126;
  // code of an SH band: by how many bits it lies below the Gaussian's exponent
  localparam int unsigned ShDropW        = 3;
  localparam int unsigned ShBand1W       = 6;  // code of an SH coefficient of band 1, signed
  localparam int unsigned ShBand2W       = 5;  // code of one of band 2 or 3, signed
  localparam int unsigned RotationW      = 20;  // view-space rotation matrix of a Gaussian, s1.18
  // signed mantissa of a factor of the covariance, normalised: the two top bits differ
  localparam int unsigned FactorW        = 23;
  localparam int unsigned WideEW         = 11;  // exponent of a product of factors, signed: nothing can leave it
  // slope of the conditional mean, s1.25, magnitude at most 1 after the swap
  localparam int unsigned SlopeW         = 27;
  localparam int unsigned ExtentW        = 22;  // half extent of a splat in the image, u18.4 pixel
  // slope of the oriented box's axis that is nearer to x, s1.16, magnitude at most 1; absent unless tile_test is 2
  localparam int unsigned TiltW          = 0;
  // half length of the oriented box along an axis (1, tilt) that is not normalised, u20.8
  localparam int unsigned SideW          = 0;
  localparam int unsigned BoxExtentW     = 0;  // half extent of the oriented box along x or y, u18.4 pixel
  localparam int unsigned AxisMW         = 0;  // normalised mantissas of pu_axes and pu_box
  localparam int unsigned ShareW         = 0;  // share of a length, u1.18, 1/2 to 1
  localparam int unsigned AxisEW         = 0;  // exponent of such a mantissa, signed
  localparam int unsigned AW             = 41;  // coefficient A, s16.CoeffF
  localparam int unsigned BcW            = 37;  // coefficients B and C, s12.CoeffF
  localparam int unsigned DefW           = 28;  // coefficients D, E and F, s3.CoeffF
  // power in a Row Unit, s20.PowerF: holds any pixel of any coefficients, nothing wraps
  localparam int unsigned PowerW         = 41;
  localparam int unsigned GradientW      = 34;  // first differences of the power, s13.PowerF
  localparam int unsigned CurveW         = 25;  // D, E and F in a Row Unit, s4.PowerF
  // a pixel counts iff power >= -PowerCut, unit 2^-PowerF: alpha >= 1/AlphaCut
  localparam int unsigned PowerCut       = 8382687;
  // how much pu_intersect's cut is below the Row Units', unit 2^-CoeffF: what rounding may add
  localparam int unsigned CutSlack       = 73728;
  // -log2(opacity) from which nothing counts: log2(AlphaCut) and three slacks, rounded up, unit 2^-OpacityF
  localparam int unsigned CutBudget      = 32799;
  // pixels that the dilation of 0.3 adds to a Gaussian's reach, and slack for the rounded mean
  localparam int unsigned ReachMargin    = 2;
  localparam int unsigned ExpF           = 17;  // fraction bits of the power that exp2 reads
  localparam int unsigned WholeW         = 4;  // whole part of a visible power, 0 to -10, without its sign
  localparam int unsigned ExpValueW      = 17;  // value of an entry of the exp2 table, u1.(ExpValueW-1)
  localparam int unsigned ExpDeltaW      = 11;  // difference of two entries, same unit; the leading bits are 0
  localparam int unsigned ExpOutW        = 18;  // 2^fraction, u1.(ExpOutW-1)
  localparam int unsigned AlphaMax       = 1014;  // largest alpha code, round(0.99 * 2^AlphaW)
  localparam int unsigned AlphaMemoryLines = 2;  // memory lines of one line of alphas in the overflow area
  localparam int unsigned StoreAddressW  = 0;  // field of a splat that says where its alphas lie; absent when late
  localparam int unsigned StoreBitW      = 0;  // flag of a splat about its alphas; absent when late
  localparam int unsigned StoreUnitW     = 0;  // unit of a splat's alpha store; absent when late
  localparam int unsigned LateAW         = 41;  // coefficient A in a splat; absent unless late
  localparam int unsigned LateBcW        = 37;  // coefficients B and C in a splat; absent unless late
  localparam int unsigned LateDefW       = 28;  // coefficients D, E and F in a splat; absent unless late
  localparam int unsigned MarkW          = 24;  // watermark of a chunk; absent unless Order is 2
  // AOVs that the machine has, one bit each: coverage, depth, median, index
  localparam int unsigned AovsBuilt      = 0;
  localparam bit HasAovs                 = 1'b0;  // pixels may have AOVs
  localparam bit HasDepths               = 1'b0;  // some of depths
  // index of a Gaussian on its way to the RUs: for the sort, the taps and an AOV; else one bit is left
  localparam int unsigned SplatIndexW    = 24;
  // index of a Gaussian behind the sort, for the taps and for an AOV; else one bit is left
  localparam int unsigned ShownIndexW    = 1;
  // depth key behind the sort, for the taps and for AOVs; else one bit is left
  localparam int unsigned ShownDepthW    = 1;
  localparam int unsigned LinearW        = 0;  // depth in an RU, u0.20 of the frame's range; or absent
  // red, green and blue of a splat, and its depth for AOVs: what an RU blends
  localparam int unsigned RuColorsW      = 36;
  localparam int unsigned RangeW         = 0;  // exponent of that range; absent likewise
  localparam int unsigned AovKinds       = 4;  // AOVs that there may be: coverage, depth, median, index
  localparam int unsigned AovsW          = 0;  // one bit for each; absent without AOVs
  localparam int unsigned AovAddressW    = 0;  // where they lie, lines of external memory; absent likewise
  localparam int unsigned BlendedW       = 0;  // Gaussians blended into a pixel; stays at the most
  localparam int unsigned ExpectedW      = 0;  // expected depth; absent unless aov_depth
  localparam int unsigned MedianW        = 0;  // median depth; absent unless aov_median
  localparam int unsigned BestW          = 0;  // weight of the Gaussian that weighs most, u1.(TW-1)
  localparam int unsigned BestIndexW     = 0;  // and its index; absent unless aov_index
  localparam int unsigned LineW          = 640;  // alphas of one region, row by row, first pixel in the low bits
  // address of a line in the alpha store, or when ext is set {area, line} of the unit's overflow areas; with lists
  // {unit, line} of the area of all alphas
  localparam int unsigned AlphaAddressW  = 24;
  // addresses of an alpha store: a ring, freed a layer at a time, of which AlphaLines have a slot
  localparam int unsigned AlphaAddresses = 2048;
  localparam int unsigned AlphaSlotW     = 10;  // slot of a line in its alpha store
  // number of a window, row by row from the frame's first to its last: at most 2^ListWindowW lists
  localparam int unsigned ListWindowW    = 12;
  localparam int unsigned ListEntryW     = 20;  // entry of a list, one line each; a list has at most 2^ListEntryW - 1
  localparam int unsigned UnitW          = 2;  // number of a unit
  localparam int unsigned GaussiansPerLine = 2;  // geometry records in a line of memory, each at its part of the line
  localparam int unsigned RegionLines    = 4;  // lines of external memory for the pixels of a region
  localparam int unsigned AddressW       = 34;  // line of 64 bytes in external memory
  localparam int unsigned MemoryW        = 512;  // a line of external memory
  localparam int unsigned HalvesW        = 2;  // halves of a line of external memory, one bit each
  localparam int unsigned StrideW        = 12;  // lines from one row of pixels to the next, in raster order
  localparam int unsigned TagW           = 5;  // who asked: the requester's port
  // a pixel stops before its transmittance falls below 1/TCut: ceil(2^(TW-1) / TCut)
  localparam int unsigned TStop          = 27;
  // transmittance below 1, at which a frame's pixels stop; absent if none stops
  localparam int unsigned RestW          = 18;
  // lines of a read, less one: a request reads up to eight lines of one aligned group
  localparam int unsigned BurstW         = 3;
  localparam int unsigned PerfW          = 40;  // a performance counter, cycles or events
  // memory ports that may write: PU alphas, SU, RU of each unit, then the lists if there are any
  localparam int unsigned WritePorts     = 12;
  // memory ports: those that may write, PU geometry, PU colour of each unit, then DOPU
  localparam int unsigned MemoryPorts    = 21;
  localparam int unsigned AovBits        = 0;  // what an RU keeps of a pixel for its AOVs (pixel_aovs_t)
  // sixteen pixels of T, red, green, blue, done, and for AOVs: a word of the pixel buffer
  localparam int unsigned PixelWordW     = 1088;
  localparam int unsigned TapLanes       = 4;  // lanes of taps of an RU: one for each group of lanes
  localparam int unsigned TapLineW       = 40;  // alphas that a lane of taps shows
  localparam int unsigned TapWordW       = 272;  // pixels that a lane of taps shows
  localparam int unsigned BusReads       = 256;  // reads that may be unanswered on the bus
  localparam int unsigned BusWrites      = 64;  // writes that may be unanswered on the bus
  localparam int unsigned BusFenced      = 64;  // reads that may wait for earlier writes
  // cycles for which the core alone is in reset, and again until it may begin
  localparam int unsigned ResetCycles    = 8;
  localparam int unsigned DescendResults = 8;  // results of the DOPU's test that may wait, each level (order 0 and 1)
  // ranges of nodes that the DOPU has asked for, each level (order 0 and 1)
  localparam int unsigned DescendJobs    = 8;
  // lines of the node tables in flight or waiting, each level (order 0 and 1)
  localparam int unsigned DescendLines   = 32;
  localparam int unsigned NearestResults = 16;  // results of the DOPU's test that may wait, each level (order 2)
  localparam int unsigned NearestOpen    = 16;  // nodes open at a time, each level (order 2)
  localparam int unsigned NearestLines   = 64;  // lines of the node tables in flight or waiting, each level (order 2)
  // chunks that wait, from which on no group is opened without need (order 2)
  localparam int unsigned NearestAhead   = 128;
  localparam int unsigned WindowMarks    = 127;  // most watermarks of a window, 2^n - 1
  localparam int unsigned ReachDepth     = 16;  // Gaussians in pu_reach: those whose test is under way (tight_cull)
  // Gaussians that pu_deal has dealt to a PU: few, they cannot go to another one
  localparam int unsigned VisibleDepth   = 4;
  // Gaussians before pu_intersect, which takes 3 to 64 cycles where the others take 8
  localparam int unsigned WalkDepth      = 16;
  localparam int unsigned PuMarks        = 16;  // watermarks inside a PU (order 2)
  // Gaussians whose line of SH coefficients is on its way: at 8 cycles each they hide 256 cycles
  localparam int unsigned ColorDepth     = 32;
  // Gaussians between pu_expand and the end of pu_color, which has room for ColorDepth lines
  localparam int unsigned ExpandDepth    = 40;
  localparam int unsigned LateDepth      = 64;  // coefficients between pu_late and the end of pu_color (late)
  // Gaussians before a PU's Row Units: one that fills the screen keeps them for hundreds of cycles
  localparam int unsigned RowJobs        = 4;
  localparam int unsigned ListJobs       = 8;  // lists whose lines are asked for
  localparam int unsigned ListLines      = 64;  // lines of lists in flight or waiting
  // lines behind each list that nobody uses: else all lists would begin in the same bank of a DRAM
  localparam int unsigned ListGap        = 132;
  localparam int unsigned SuChains       = 64;  // released chains and ends that wait for an SU's splitter
  localparam int unsigned SuWaiting      = 32;  // sorted keys in an SU that wait for their records
  localparam int unsigned SuAnswers      = 32;  // lines that an SU has asked for
  localparam int unsigned RuLocalLines   = 4;  // lines of alpha stores that an RU has asked for
  localparam int unsigned RuRowLines     = 2;  // lines of alphas that an RU's own Row Units have ready (late)
  localparam int unsigned RuGroups       = 4;  // groups of four lanes in an RU (quads)
  localparam int unsigned RuHalves       = 16;  // halves of regions that wait before a group of lanes (quads)
  localparam int unsigned RuDrained      = 2;  // words of finished pixels that wait for memory in an RU (quads)
  localparam int unsigned NodeLines      = 64;  // lines of the node tables in flight or waiting, each level
  localparam int unsigned SuMarks        = 256;  // watermarks of two windows, or ends of two layers, that an SU keeps
  localparam int unsigned SuWays         = 16;  // sorted runs in external memory that an SU merges at once (overflow)
  localparam int unsigned SuWayLines     = 8;  // lines of each of them that its pool holds, eight slots each
  localparam int unsigned SuRunKeys      = 6;  // keys of a run in a line, each with the number of its record
  // records of a set that spilled that return to the pool of an SU: no more may be left
  localparam int unsigned SuRefill       = 704;
  localparam int unsigned RuQueue        = 256;  // Gaussians before an RU: evens out which one has more to do
  localparam int unsigned RuRecords      = 40;  // Gaussians in an RU whose lines of alphas are on their way

  // What a beat of a stream is.
  localparam logic [1:0] KindData = 2'd0;
  localparam logic [1:0] KindLayerEnd = 2'd1;
  localparam logic [1:0] KindWindowEnd = 2'd2;
  localparam logic [1:0] KindPartEnd = 2'd3;

  // What a unit does in a cycle, see pipegs_perf: starved has nothing to do, blocked waits for who takes its output.
  localparam logic [1:0] PerfBusy = 2'd0;
  localparam logic [1:0] PerfStarved = 2'd1;
  localparam logic [1:0] PerfBlocked = 2'd2;
  localparam logic [1:0] PerfMemory = 2'd3;

  // Chords of 2^f (delta 0: steps): entry i is {0, delta, value}, entry 0 lowest. See cpp_model/lib/math/exp2.hpp.
  localparam int unsigned Exp2EntryW = 32;
  localparam logic [64*Exp2EntryW-1:0] Exp2Table = {
    32'hb09fa7c, 32'haebf507, 32'hacbefa2, 32'haafea4b, 32'ha91e503, 32'ha75dfc9, 32'ha57da9e, 32'ha39d582,
    32'ha1fd073, 32'ha03cb72, 32'h9e7c67f, 32'h9cbc19a, 32'h9b1bcc2, 32'h997b7f7, 32'h97bb33a, 32'h961ae8a,
    32'h947a9e7, 32'h92fa550, 32'h915a0c6, 32'h8fb9c49, 32'h8e397d8, 32'h8cb9373, 32'h8b18f1b, 32'h89b8ace,
    32'h881868e, 32'h86b8259, 32'h8557e2f, 32'h83d7a11, 32'h82575ff, 32'h81171f7, 32'h7f96dfb, 32'h7e36a0a,
    32'h7cd6624, 32'h7b96248, 32'h7a35e77, 32'h78f5ab0, 32'h77956f4, 32'h7635343, 32'h7514f9b, 32'h73b4bfe,
    32'h729486a, 32'h71344e1, 32'h7014161, 32'h6ef3dea, 32'h6d93a7e, 32'h6c9371a, 32'h6b333c1, 32'h6a33070,
    32'h6912d28, 32'h67d29ea, 32'h66d26b4, 32'h6592388, 32'h6492064, 32'h6391d48, 32'h6251a36, 32'h615172c,
    32'h605142a, 32'h5f51130, 32'h5e30e3f, 32'h5d30b56, 32'h5c50874, 32'h5b3059b, 32'h5a302ca, 32'h5950000
  };

  // Weights of a Gaussian's reach, u1.8, by the six leading bits of -log2(opacity). See cpp_model/pu/front/pu_cull.hpp.
  localparam logic [64*9-1:0] CullWeights = {
    9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1,
    9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1,
    9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1,
    9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1, 9'd1,
    9'd45, 9'd64, 9'd79, 9'd91, 9'd101, 9'd111, 9'd120, 9'd128,
    9'd136, 9'd143, 9'd150, 9'd157, 9'd164, 9'd170, 9'd176, 9'd181,
    9'd187, 9'd192, 9'd198, 9'd203, 9'd208, 9'd213, 9'd218, 9'd222,
    9'd227, 9'd231, 9'd236, 9'd240, 9'd244, 9'd248, 9'd252, 9'd256
  };

  // Their squares for pu_reach, u1.12. See cpp_model/pu/front/pu_reach.hpp.
  localparam logic [64*13-1:0] ReachWeights = {
    13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1,
    13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1,
    13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1,
    13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd1, 13'd5,
    13'd133, 13'd262, 13'd390, 13'd518, 13'd646, 13'd774, 13'd902, 13'd1030,
    13'd1158, 13'd1286, 13'd1414, 13'd1542, 13'd1671, 13'd1799, 13'd1927, 13'd2055,
    13'd2183, 13'd2311, 13'd2439, 13'd2567, 13'd2695, 13'd2823, 13'd2951, 13'd3080,
    13'd3208, 13'd3336, 13'd3464, 13'd3592, 13'd3720, 13'd3848, 13'd3976, 13'd4104
  };

  // -log2(opacity), u4.OpacityF, of each code. See cpp_model/pu/front/pu_decode.hpp.
  localparam logic [256*16-1:0] OpacityCodes = {
    16'd0, 16'd23, 16'd47, 16'd70, 16'd93, 16'd117, 16'd141, 16'd164,
    16'd188, 16'd212, 16'd236, 16'd261, 16'd285, 16'd309, 16'd334, 16'd358,
    16'd383, 16'd408, 16'd433, 16'd458, 16'd483, 16'd508, 16'd533, 16'd559,
    16'd584, 16'd610, 16'd635, 16'd661, 16'd687, 16'd713, 16'd740, 16'd766,
    16'd792, 16'd819, 16'd846, 16'd872, 16'd899, 16'd926, 16'd954, 16'd981,
    16'd1008, 16'd1036, 16'd1064, 16'd1091, 16'd1119, 16'd1147, 16'd1176, 16'd1204,
    16'd1232, 16'd1261, 16'd1290, 16'd1319, 16'd1348, 16'd1377, 16'd1406, 16'd1436,
    16'd1465, 16'd1495, 16'd1525, 16'd1555, 16'd1585, 16'd1616, 16'd1646, 16'd1677,
    16'd1708, 16'd1739, 16'd1770, 16'd1801, 16'd1833, 16'd1864, 16'd1896, 16'd1928,
    16'd1961, 16'd1993, 16'd2026, 16'd2058, 16'd2091, 16'd2124, 16'd2158, 16'd2191,
    16'd2225, 16'd2259, 16'd2293, 16'd2327, 16'd2361, 16'd2396, 16'd2431, 16'd2466,
    16'd2501, 16'd2537, 16'd2572, 16'd2608, 16'd2644, 16'd2681, 16'd2717, 16'd2754,
    16'd2791, 16'd2829, 16'd2866, 16'd2904, 16'd2942, 16'd2980, 16'd3019, 16'd3057,
    16'd3096, 16'd3136, 16'd3175, 16'd3215, 16'd3255, 16'd3295, 16'd3336, 16'd3377,
    16'd3418, 16'd3460, 16'd3501, 16'd3543, 16'd3586, 16'd3628, 16'd3671, 16'd3715,
    16'd3758, 16'd3802, 16'd3846, 16'd3891, 16'd3936, 16'd3981, 16'd4027, 16'd4073,
    16'd4119, 16'd4166, 16'd4213, 16'd4260, 16'd4308, 16'd4357, 16'd4405, 16'd4454,
    16'd4504, 16'd4554, 16'd4604, 16'd4655, 16'd4706, 16'd4757, 16'd4809, 16'd4862,
    16'd4915, 16'd4968, 16'd5022, 16'd5077, 16'd5132, 16'd5187, 16'd5243, 16'd5300,
    16'd5357, 16'd5415, 16'd5473, 16'd5532, 16'd5591, 16'd5651, 16'd5712, 16'd5773,
    16'd5835, 16'd5897, 16'd5960, 16'd6024, 16'd6089, 16'd6154, 16'd6220, 16'd6287,
    16'd6355, 16'd6423, 16'd6492, 16'd6562, 16'd6633, 16'd6704, 16'd6777, 16'd6850,
    16'd6925, 16'd7000, 16'd7076, 16'd7153, 16'd7232, 16'd7311, 16'd7391, 16'd7473,
    16'd7556, 16'd7639, 16'd7724, 16'd7811, 16'd7898, 16'd7987, 16'd8077, 16'd8169,
    16'd8262, 16'd8356, 16'd8453, 16'd8550, 16'd8650, 16'd8751, 16'd8853, 16'd8958,
    16'd9064, 16'd9173, 16'd9283, 16'd9396, 16'd9511, 16'd9628, 16'd9747, 16'd9869,
    16'd9993, 16'd10120, 16'd10250, 16'd10383, 16'd10519, 16'd10658, 16'd10800, 16'd10946,
    16'd11096, 16'd11249, 16'd11407, 16'd11569, 16'd11735, 16'd11907, 16'd12083, 16'd12265,
    16'd12452, 16'd12646, 16'd12847, 16'd13054, 16'd13269, 16'd13492, 16'd13724, 16'd13965,
    16'd14216, 16'd14479, 16'd14754, 16'd15042, 16'd15345, 16'd15665, 16'd16003, 16'd16361,
    16'd16742, 16'd17150, 16'd17588, 16'd18061, 16'd18575, 16'd19138, 16'd19761, 16'd20457,
    16'd21246, 16'd22157, 16'd23234, 16'd24553, 16'd26253, 16'd28649, 16'd32745, 16'd65535
  };

  // Mantissas of the sixteenths of an octave.
  localparam logic [16*12-1:0] ScaleSteps = {
    12'd3749, 12'd3416, 12'd3098, 12'd2793, 12'd2501, 12'd2221, 12'd1953, 12'd1697,
    12'd1451, 12'd1216, 12'd991, 12'd775, 12'd568, 12'd371, 12'd181, 12'd0
  };

  typedef struct packed {
    logic signed [WorldW-1:0] z;
    logic signed [WorldW-1:0] y;
    logic signed [WorldW-1:0] x;
  } position_t;
  localparam int unsigned PositionBits = 120;

  typedef struct packed {
    logic signed [RotW-1:0] w22;
    logic signed [RotW-1:0] w21;
    logic signed [RotW-1:0] w20;  // row 2 (forward)
    logic signed [RotW-1:0] w12;
    logic signed [RotW-1:0] w11;
    logic signed [RotW-1:0] w10;  // row 1 (down)
    logic signed [RotW-1:0] w02;
    logic signed [RotW-1:0] w01;
    logic signed [RotW-1:0] w00;  // row 0 (right)
  } rotation_t;
  localparam int unsigned RotationBits = 234;

  typedef struct packed {
    logic signed [CamQuatW-1:0] z;
    logic signed [CamQuatW-1:0] y;
    logic signed [CamQuatW-1:0] x;
    logic signed [CamQuatW-1:0] w;
  } quaternion_t;
  localparam int unsigned QuaternionBits = 80;

  typedef struct packed {
    quaternion_t quaternion;  // the same rotation
    rotation_t rotation;
    position_t position;  // its centre
  } camera_t;
  localparam int unsigned CameraPoseBits = 434;

  typedef struct packed {
    logic [WorldW-1:0] near_plane;  // near plane, world units
    logic [SpreadW-1:0] spread_y;
    logic [SpreadW-1:0] spread_x;  // 2 ln AlphaCut * fx^2 * (1 + 2^-8), rounded up: (1 + m/2^8) 2^e pixel^2
    logic [ReachW-1:0] reach_y;
    logic [ReachW-1:0] reach_x;  // sqrt(2 ln AlphaCut) * fx * sqrt(1 + limit_x^2), rounded up, u18.14
    logic [TanW-1:0] limit_y;
    logic [TanW-1:0] limit_x;  // 1.3 tan(fov/2): guard band of the Jacobian, u4.TanF
    logic signed [CenterW-1:0] center_y;
    logic signed [CenterW-1:0] center_x;  // s15.12 pixel; pixel i has its centre at i
    logic [FocalW-1:0] focal_y;
    logic [FocalW-1:0] focal_x;  // u14.14 pixel
  } lens_t;
  localparam int unsigned LensBits = 296;

  typedef struct packed {
    logic [FocalW-1:0] scale_z;
    logic [FocalW-1:0] scale_y;
    logic [FocalW-1:0] scale_x;  // cells per world unit * 2^WorldW
    position_t low;  // its low corner
  } grid_t;
  localparam int unsigned GridBits = 204;

  typedef struct packed {
    logic [AddressW-1:0] overflow;  // first line of the overflow areas
    logic [AddressW-1:0] pixels;  // first line of the frame
    logic [KindW-1:0] sh_degree;  // degree of the SH coefficients, at most ShDegree
    logic [AddressW-1:0] colors;  // first line of the SH coefficients
    logic [AddressW-1:0] gaussians;  // first line of the Gaussians' geometry
    logic [AddressW-1:0] chunks;  // first line of the chunk table
    logic [AddressW-1:0] groups;  // first line of the group table
    logic [AddressW-1:0] cells;  // first line of the cell table
  } tables_t;
  localparam int unsigned TablesBits = 240;

  typedef struct packed {
    logic [AddressW-1:0] lines;  // how many
    logic [AddressW-1:0] first;
  } span_t;
  localparam int unsigned SpanBits = 68;

  typedef struct packed {
    logic [AddressW-1:0] picture;
    logic [AddressW-1:0] overflow;  // any number: area_lines, area_place and area_first divide it
    logic [AddressW-1:0] pixels;
    logic [AddressW-1:0] colors;
    logic [AddressW-1:0] gaussians;
    logic [AddressW-1:0] chunks;
    logic [AddressW-1:0] groups;
    logic [AddressW-1:0] cells;
  } areas_t;
  localparam int unsigned AreasBits = 272;

  typedef struct packed {
    logic [WindowW-1:0] last_y;  // row of the last
    logic [WindowW-1:0] last_x;  // column of the last
    logic [WindowW-1:0] first_y;  // row of the first
    logic [WindowW-1:0] first_x;  // column of the first
  } windows_t;
  localparam int unsigned WindowsBits = 40;

  typedef struct packed {
    logic [ClosedW-1:0] bottom;
    logic [ClosedW-1:0] top;
    logic [ClosedW-1:0] right;
    logic [ClosedW-1:0] left;
  } closed_t;
  localparam int unsigned ClosedBits = 16;

  typedef struct packed {
    closed_t part_3;
    closed_t part_2;
    closed_t part_1;
    closed_t part_0;  // of a part alone, if it has parts; with two eyes of the first one's
    closed_t whole;  // of all of it
    logic [WindowW-1:0] window_y;  // row of the window
    logic [WindowW-1:0] window_x;  // column of the window
    logic known;  // all RUs are in one window, this one
  } open_t;
  localparam int unsigned OpenBits = 101;

  typedef struct packed {
    logic [RestW-1:0] rest;  // u0.(TW-1): with less left a pixel's next Gaussian takes all; 0: it stops at 1/TCut
    windows_t windows;
    logic [SizeW-1:0] height;  // pixels
    logic [SizeW-1:0] width;  // pixels
  } raster_t;
  localparam int unsigned RasterBits = 88;

  typedef struct packed {
    // Gaussians at one depth from which on a window is walked part by part; 0: never is
    logic [WalkMostW-1:0] walk_most;
    raster_t raster;
    tables_t tables;
    grid_t grid;
    lens_t lens;
    camera_t camera;
  } frame_t;
  localparam int unsigned FrameBits = 1286;

  typedef struct packed {
    logic [CountW-1:0] count;  // cell: groups; group: chunks; chunk: Gaussians
    // cell: first group; group: first chunk; chunk: slot of the first Gaussian, that of a line
    logic [SlotW-1:0] first;
    // largest effective scale in the node, rounded up: scale * sqrt(ln(AlphaCut opacity) / ln AlphaCut)
    logic [ScaleW-1:0] scale_max;
    logic [ExpW-1:0] offset_exp;  // unit of the offsets of the chunk's means is 2^offset_exp world units
    logic [ExpW-1:0] half_exp;
    logic [HullW-1:0] up_z;
    logic [HullW-1:0] up_y;
    logic [HullW-1:0] up_x;  // and upwards
    logic [HullW-1:0] down_z;
    logic [HullW-1:0] down_y;
    // how far the ellipsoids on which alpha is 1/AlphaCut reach from the centre downwards, unit 2^(half_exp + 1)
    logic [HullW-1:0] down_x;
    logic [HalfW-1:0] half_z;
    logic [HalfW-1:0] half_y;
    logic [HalfW-1:0] half_x;  // half extents, unit 2^half_exp
    logic signed [WorldW-1:0] center_z;
    logic signed [WorldW-1:0] center_y;
    logic signed [WorldW-1:0] center_x;  // centre of the bounding box of the means, world units
  } node_t;
  localparam int unsigned NodeBits = 256;

  typedef struct packed {
    logic [IndexW-1:0] index;  // coded: its slot
    logic signed [BaseW-1:0] base_b;
    logic signed [BaseW-1:0] base_g;
    logic signed [BaseW-1:0] base_r;  // SH band 0 + 1/2
    logic [OpacityW-1:0] opacity;  // -log2(opacity)
    logic [ScaleW-1:0] scale_2;
    logic [ScaleW-1:0] scale_1;
    logic [ScaleW-1:0] scale_0;  // standard deviation along the first axis
    logic signed [QuatW-1:0] qz;
    logic signed [QuatW-1:0] qy;
    logic signed [QuatW-1:0] qx;
    logic signed [QuatW-1:0] qw;  // unit quaternion, s0.(QuatW-1)
    logic signed [PosW-1:0] offset_z;
    logic signed [PosW-1:0] offset_y;
    logic signed [PosW-1:0] offset_x;  // mean - chunk centre
  } gaussian_t;
  localparam int unsigned GaussianRecordBits = 254;

  typedef struct packed {
    logic signed [BaseCodeW-1:0] base_b;
    logic signed [BaseCodeW-1:0] base_g;
    logic signed [BaseCodeW-1:0] base_r;  // SH band 0
    logic [OpacityCodeW-1:0] opacity;
    logic [ScaleCodeW-1:0] scale_2;
    logic [ScaleCodeW-1:0] scale_1;
    logic [ScaleCodeW-1:0] scale_0;  // standard deviation along the first axis
    logic signed [TurnCodeW-1:0] turn_2;
    logic signed [TurnCodeW-1:0] turn_1;
    logic signed [TurnCodeW-1:0] turn_0;  // the other three in their order
    logic [AxisW-1:0] axis;  // component of the quaternion that is largest; it is not negative, and not stored
    logic signed [OffsetCodeW-1:0] offset_z;
    logic signed [OffsetCodeW-1:0] offset_y;
    logic signed [OffsetCodeW-1:0] offset_x;  // mean - chunk centre
  } code_t;
  localparam int unsigned GaussianCodeBits = 127;

  typedef struct packed {
    logic signed [TestW-1:0] reach;  // of the near plane: -1, it multiplies the near distance
    logic signed [TestW-1:0] nz;
    logic signed [TestW-1:0] ny;
    logic signed [TestW-1:0] nx;  // world-space normal, one unit for all four numbers
  } plane_t;
  localparam int unsigned PlaneBits = 80;

  typedef struct packed {
    logic [MarkW-1:0] watermark;  // of a layer's end: no depth key of a later chunk of the window is smaller; else 0
    logic [CountW-1:0] count;  // Gaussians
    logic [SlotW-1:0] slot;  // first Gaussian: that of a line
    logic [ExpW-1:0] offset_exp;
    logic [ExpW-1:0] view_exp;
    logic signed [ViewW-1:0] origin_z;
    logic signed [ViewW-1:0] origin_y;
    logic signed [ViewW-1:0] origin_x;  // chunk centre in view space, unit 2^view_exp
    logic [WalkW-1:0] walk;
    logic [WindowW-1:0] window_y;
    logic [WindowW-1:0] window_x;
    logic [KindW-1:0] kind;
  } chunk_t;
  localparam int unsigned ChunkBits = 185;

  typedef struct packed {
    logic [SlotW-1:0] slot;
    code_t code;
    logic [ExpW-1:0] offset_exp;
    logic [ExpW-1:0] view_exp;
    logic signed [ViewW-1:0] origin_z;
    logic signed [ViewW-1:0] origin_y;
    logic signed [ViewW-1:0] origin_x;  // chunk centre in view space, unit 2^view_exp
    logic [WalkW-1:0] walk;
    logic [WindowW-1:0] window_y;
    logic [WindowW-1:0] window_x;
    logic [KindW-1:0] kind;
  } coded_t;
  localparam int unsigned CodedBits = 272;

  typedef struct packed {
    logic [SlotW-1:0] slot;
    logic [IndexW-1:0] index;
    logic signed [BaseW-1:0] base_b;
    logic signed [BaseW-1:0] base_g;
    logic signed [BaseW-1:0] base_r;
    logic [OpacityW-1:0] opacity;
    logic [ScaleW-1:0] scale_2;
    logic [ScaleW-1:0] scale_1;
    logic [ScaleW-1:0] scale_0;
    logic signed [QuatW-1:0] qz;
    logic signed [QuatW-1:0] qy;
    logic signed [QuatW-1:0] qx;
    logic signed [QuatW-1:0] qw;
    logic signed [PosW-1:0] offset_z;
    logic signed [PosW-1:0] offset_y;
    logic signed [PosW-1:0] offset_x;  // mean - chunk centre, unit 2^offset_exp world units
    logic [ExpW-1:0] offset_exp;
    logic [ExpW-1:0] view_exp;
    logic signed [ViewW-1:0] origin_z;
    logic signed [ViewW-1:0] origin_y;
    logic signed [ViewW-1:0] origin_x;  // chunk centre in view space, unit 2^view_exp
    logic [WalkW-1:0] walk;
    logic [WindowW-1:0] window_y;
    logic [WindowW-1:0] window_x;
    logic [KindW-1:0] kind;
  } fetched_t;
  localparam int unsigned FetchedBits = 399;

  typedef struct packed {
    logic [SlotW-1:0] slot;
    logic [IndexW-1:0] index;
    logic signed [BaseW-1:0] base_b;
    logic signed [BaseW-1:0] base_g;
    logic signed [BaseW-1:0] base_r;
    logic [OpacityW-1:0] opacity;
    logic [ScaleW-1:0] scale_2;
    logic [ScaleW-1:0] scale_1;
    logic [ScaleW-1:0] scale_0;
    logic signed [QuatW-1:0] qz;
    logic signed [QuatW-1:0] qy;
    logic signed [QuatW-1:0] qx;
    logic signed [QuatW-1:0] qw;
    logic [ExpW-1:0] view_exp;
    logic signed [ViewW-1:0] view_z;
    logic signed [ViewW-1:0] view_y;
    logic signed [ViewW-1:0] view_x;  // mean in view space, unit 2^view_exp
    logic [WalkW-1:0] walk;
    logic [WindowW-1:0] window_y;
    logic [WindowW-1:0] window_x;
    logic [KindW-1:0] kind;
  } visible_t;
  localparam int unsigned VisibleBits = 339;

  typedef struct packed {
    logic untested;  // its scale has no room in view units: it is kept
    logic signed [GapW-1:0] gap_y;
    // pixels from the mean to the window with its margin, times z: not too large; not positive inside
    logic signed [GapW-1:0] gap_x;
    logic [CutShiftW-1:0] cut;
    logic signed [CutW-1:0] z;
    logic signed [CutW-1:0] y;
    logic signed [CutW-1:0] x;  // mean in view space, unit 2^(view_exp + cut)
  } gap_t;
  localparam int unsigned GapBits = 142;

  typedef struct packed {
    gap_t gap;
    visible_t visible;
  } culled_t;
  localparam int unsigned CulledBits = 481;

  typedef struct packed {
    logic [ScaleW-1:0] scale_2;
    logic [ScaleW-1:0] scale_1;
    logic [ScaleW-1:0] scale_0;
    logic signed [QuatW-1:0] qz;
    logic signed [QuatW-1:0] qy;
    logic signed [QuatW-1:0] qx;
    logic signed [QuatW-1:0] qw;
    logic signed [FloatEW-1:0] inv_z_e;
    logic [MantissaW-1:0] inv_z_m;  // 1/z = m * 2^e per world unit, m normalised
    logic signed [TanW-1:0] tan_y;
    logic signed [TanW-1:0] tan_x;  // x/z clamped to the guard band
    logic [KindW-1:0] kind;
  } projected_t;
  localparam int unsigned ProjectedBits = 205;

  typedef struct packed {
    logic [OpacityW-1:0] opacity;
    logic signed [MeanW-1:0] mean_y;
    logic signed [MeanW-1:0] mean_x;  // projected mean relative to the window's first pixel, s18.MeanF, saturated
  } center_t;
  localparam int unsigned CenterBits = 80;

  typedef struct packed {
    logic [WalkW-1:0] walk;
    logic [SlotW-1:0] slot;
    logic [IndexW-1:0] index;
    logic signed [BaseW-1:0] base_b;
    logic signed [BaseW-1:0] base_g;
    logic signed [BaseW-1:0] base_r;
    logic signed [DirectionW-1:0] dir_z;
    logic signed [DirectionW-1:0] dir_y;
    logic signed [DirectionW-1:0] dir_x;  // view-space direction to the mean, block-normalised
    logic [DepthW-1:0] depth;  // depth key of view z: exponent, then mantissa
  } payload_t;
  localparam int unsigned PayloadBits = 171;

  typedef struct packed {
    logic [PartW-1:0] part;
    payload_t payload;
  } parted_t;
  localparam int unsigned PartedBits = 173;

  typedef struct packed {
    logic [ScaleW-1:0] scale_2;
    logic [ScaleW-1:0] scale_1;
    logic [ScaleW-1:0] scale_0;
    logic signed [RotationW-1:0] r22;
    logic signed [RotationW-1:0] r21;
    logic signed [RotationW-1:0] r20;
    logic signed [RotationW-1:0] r12;
    logic signed [RotationW-1:0] r11;
    logic signed [RotationW-1:0] r10;
    logic signed [RotationW-1:0] r02;
    logic signed [RotationW-1:0] r01;
    logic signed [RotationW-1:0] r00;  // Gaussian's axes in view space: R' = W R, columns are the axes, s1.18
    logic signed [FloatEW-1:0] inv_z_e;
    logic [MantissaW-1:0] inv_z_m;
    logic signed [TanW-1:0] tan_y;
    logic signed [TanW-1:0] tan_x;
    logic [KindW-1:0] kind;
  } oriented_t;
  localparam int unsigned OrientedBits = 321;

  typedef struct packed {
    logic [ScaleW-1:0] scale_2;
    logic [ScaleW-1:0] scale_1;
    logic [ScaleW-1:0] scale_0;
    logic signed [WideEW-1:0] gy_e;
    logic [MantissaW-1:0] gy_m;  // focal_y / z
    logic signed [WideEW-1:0] gx_e;
    logic [MantissaW-1:0] gx_m;  // focal_x / z, pixels per world unit
    logic signed [WideEW-1:0] n_2_e;
    logic signed [FactorW-1:0] n_2_m;
    logic signed [WideEW-1:0] n_1_e;
    logic signed [FactorW-1:0] n_1_m;
    logic signed [WideEW-1:0] n_0_e;
    logic signed [FactorW-1:0] n_0_m;  // cross product of the rows: R'0j tan_x + R'1j tan_y + R'2j
    logic signed [WideEW-1:0] v1_2_e;
    logic signed [FactorW-1:0] v1_2_m;
    logic signed [WideEW-1:0] v1_1_e;
    logic signed [FactorW-1:0] v1_1_m;
    logic signed [WideEW-1:0] v1_0_e;
    logic signed [FactorW-1:0] v1_0_m;  // row y: R'1j - tan_y R'2j
    logic signed [WideEW-1:0] v0_2_e;
    logic signed [FactorW-1:0] v0_2_m;
    logic signed [WideEW-1:0] v0_1_e;
    logic signed [FactorW-1:0] v0_1_m;
    logic signed [WideEW-1:0] v0_0_e;
    logic signed [FactorW-1:0] v0_0_m;  // J R', row x without its factor focal/z: R'0j - tan_x R'2j, j = 0..2
    logic [KindW-1:0] kind;
  } jacobian_t;
  localparam int unsigned JacobianBits = 428;

  typedef struct packed {
    logic signed [WideEW-1:0] gg_e;
    logic [MantissaW-1:0] gg_m;  // (gx gy)^2
    logic signed [WideEW-1:0] gxy_e;
    logic [MantissaW-1:0] gxy_m;  // gx gy
    logic signed [WideEW-1:0] gyy_e;
    logic [MantissaW-1:0] gyy_m;  // gy^2
    logic signed [WideEW-1:0] gxx_e;
    logic [MantissaW-1:0] gxx_m;  // gx^2, m normalised
    logic signed [WideEW-1:0] t_e;
    logic signed [FactorW-1:0] t_2;
    logic signed [FactorW-1:0] t_1;
    logic signed [FactorW-1:0] t_0;  // n_k * scale_i * scale_j, i and j the other two axes
    logic signed [WideEW-1:0] u1_e;
    logic signed [FactorW-1:0] u1_2;
    logic signed [FactorW-1:0] u1_1;
    logic signed [FactorW-1:0] u1_0;  // v1_j * scale_j
    logic signed [WideEW-1:0] u0_e;
    logic signed [FactorW-1:0] u0_2;
    logic signed [FactorW-1:0] u0_1;
    logic signed [FactorW-1:0] u0_0;  // v0_j * scale_j
    logic [KindW-1:0] kind;
  } factors_t;
  localparam int unsigned FactorsBits = 374;

  typedef struct packed {
    logic [MantissaW-1:0] gg_m;
    logic [MantissaW-1:0] gxy_m;
    logic [MantissaW-1:0] gyy_m;
    logic [MantissaW-1:0] gxx_m;
    logic signed [WideEW-1:0] b_e;
    logic signed [FactorW-1:0] b_m;  // u0 . u1, m normalised or 0
    logic signed [WideEW-1:0] d_e;
    logic [MantissaW-1:0] d_m;  // |t|^2
    logic signed [WideEW-1:0] c_e;
    logic [MantissaW-1:0] c_m;  // |u1|^2
    logic signed [WideEW-1:0] a_e;
    logic [MantissaW-1:0] a_m;  // |u0|^2, m normalised or 0
    logic [KindW-1:0] kind;
  } squares_t;
  localparam int unsigned SquaresBits = 223;

  typedef struct packed {
    logic [OpacityW-1:0] opacity;
    logic signed [FloatEW-1:0] det_e;
    logic [MantissaW-1:0] det_m;  // determinant = m * 2^e pixel^4, m normalised
    logic signed [FloatEW-1:0] c_e;
    logic [MantissaW-1:0] c_m;  // covariance yy, 0.3 included, m normalised
    logic signed [FloatEW-1:0] b_e;
    logic signed [SlopeW-1:0] b_m;  // covariance xy = m * 2^e, signed, not normalised
    logic signed [FloatEW-1:0] a_e;
    logic [MantissaW-1:0] a_m;  // covariance xx, 0.3 included = m * 2^e pixel^2, m normalised
    logic signed [MeanW-1:0] mean_y;
    logic signed [MeanW-1:0] mean_x;
    logic [KindW-1:0] kind;
  } covariance_t;
  localparam int unsigned CovarianceBits = 211;

  typedef struct packed {
    logic swap;  // 1 when a > c: the longer axis is the one nearer to x
    logic [OpacityW-1:0] opacity;
    logic signed [FloatEW-1:0] det_e;
    logic [MantissaW-1:0] det_m;
    logic signed [FloatEW-1:0] c_e;
    logic [MantissaW-1:0] c_m;
    logic signed [FloatEW-1:0] b_e;
    logic signed [SlopeW-1:0] b_m;
    logic signed [FloatEW-1:0] a_e;
    logic [MantissaW-1:0] a_m;  // the covariance as it came
    logic signed [MeanW-1:0] mean_y;
    logic signed [MeanW-1:0] mean_x;
    logic [KindW-1:0] kind;
  } axes_t;
  localparam int unsigned AxesBits = 212;

  typedef struct packed {
    logic [OpacityW-1:0] opacity;
    logic signed [FloatEW-1:0] wide_e;
    logic [MantissaW-1:0] wide_m;  // k / variance along the wide axis: k/c (k/a when swapped) = m * 2^e
    logic signed [FloatEW-1:0] narrow_e;
    // k / conditional variance: k c/det (k a/det when swapped) = m * 2^e, k = log2(e)/2
    logic [MantissaW-1:0] narrow_m;
    logic signed [SlopeW-1:0] slope_m;  // slope of the conditional mean: b/c (b/a when swapped) = m * 2^-25
    logic swap;  // 1 when a > c: the roles of x and y are exchanged below
    logic [ExtentW-1:0] extent_y;  // half height
    // half width of the box outside which alpha < 1/AlphaCut, or of the oriented box, rounded up, u18.4 pixel
    logic [ExtentW-1:0] extent_x;
    logic signed [MeanW-1:0] mean_y;
    logic signed [MeanW-1:0] mean_x;
    logic [KindW-1:0] kind;
  } conic_t;
  localparam int unsigned ConicBits = 216;

  typedef struct packed {
    logic [ColorW-1:0] blue;
    logic [ColorW-1:0] green;
    logic [ColorW-1:0] red;
    logic [ListWindowW-1:0] window;  // its number
    logic [SplatIndexW-1:0] index;
    logic [DepthW-1:0] depth;
  } listed_t;
  localparam int unsigned ListedBits = 96;

  typedef struct packed {
    logic signed [DefW-1:0] f;
    logic signed [DefW-1:0] e;
    logic signed [DefW-1:0] d;  // power = A + B x + C y + D x^2 + E y^2 + F x y, Eq. 3
    logic signed [BcW-1:0] c;  // d/dy at the first pixel
    logic signed [BcW-1:0] b;  // d/dx at the first pixel
    logic signed [AW-1:0] a;  // power at the window's first pixel, -log2(opacity) subtracted: alpha = 2^power
    logic dead;  // a coefficient left its range: no pixel of the window can reach 1/AlphaCut
    logic [ExtentW-1:0] extent_y;
    logic [ExtentW-1:0] extent_x;
    logic signed [MeanW-1:0] mean_y;
    logic signed [MeanW-1:0] mean_x;
    logic [KindW-1:0] kind;
  } coeff_t;
  localparam int unsigned CoeffBits = 310;

  typedef struct packed {
    // regions that hold a pixel with alpha >= 1/AlphaCut: the 4-bit bitmap of each tile, row by row of regions
    logic [MaskW-1:0] mask;
    logic signed [DefW-1:0] f;
    logic signed [DefW-1:0] e;
    logic signed [DefW-1:0] d;
    logic signed [BcW-1:0] c;
    logic signed [BcW-1:0] b;
    logic signed [AW-1:0] a;
    logic [KindW-1:0] kind;
  } tiles_t;
  localparam int unsigned TilesBits = 265;

  typedef struct packed {
    logic index;
    logic ext;  // the lines lie in an overflow area
    logic [AlphaAddressW-1:0] address;  // of the line of the mask's first region; the others follow
    logic [MaskW-1:0] mask;
    logic signed [DefW-1:0] f;
    logic signed [DefW-1:0] e;
    logic signed [DefW-1:0] d;
    logic signed [BcW-1:0] c;
    logic signed [BcW-1:0] b;
    logic signed [AW-1:0] a;
    logic [KindW-1:0] kind;
  } row_job_t;
  localparam int unsigned RowJobBits = 291;

  typedef struct packed {
    logic [RegionW-1:0] region;
    logic index;
    logic ext;
    logic [AlphaAddressW-1:0] address;
    logic signed [CurveW-1:0] twist;  // F
    logic signed [CurveW-1:0] curve_y;  // E
    logic signed [CurveW-1:0] curve_x;  // D
    logic signed [GradientW-1:0] slope_y;  // d/dy there
    logic signed [GradientW-1:0] slope_x;  // d/dx there
    logic signed [PowerW-1:0] power;  // power at the region's first pixel
    logic [KindW-1:0] kind;
  } region_t;
  localparam int unsigned RegionBits = 220;

  typedef struct packed {
    logic visible;  // power >= -PowerCut
    logic [WholeW-1:0] whole;  // minus the whole part
    logic [ExpF-1:0] fraction;
  } exponent_t;
  localparam int unsigned ExponentBits = 22;

  typedef struct packed {
    logic [RegionW-1:0] region;
    logic index;
    logic ext;
    logic [AlphaAddressW-1:0] address;
    logic [KindW-1:0] kind;
  } alphas_t;
  localparam int unsigned AlphasBits = 36;

  typedef struct packed {
    logic signed [BaseW-1:0] base_b;
    logic signed [BaseW-1:0] base_g;
    logic signed [BaseW-1:0] base_r;
    logic signed [DirectionW-1:0] dir_z;
    logic signed [DirectionW-1:0] dir_y;
    logic signed [DirectionW-1:0] dir_x;
    logic ext;
    logic [AlphaAddressW-1:0] address;
    logic [MaskW-1:0] mask;
    logic [SlotW-1:0] slot;
    logic [SplatIndexW-1:0] index;
    logic [DepthW-1:0] depth;
    logic [KindW-1:0] kind;
  } color_job_t;
  localparam int unsigned ColorJobBits = 259;

  typedef struct packed {
    logic signed [BaseW-1:0] base_b;
    logic signed [BaseW-1:0] base_g;
    logic signed [BaseW-1:0] base_r;
    logic ext;
    logic [AlphaAddressW-1:0] address;
    logic [MaskW-1:0] mask;
    logic [QuarterW-1:0] quarter;  // where the coefficients lie in their line, if it holds those of more than one
    logic [SplatIndexW-1:0] index;
    logic [DepthW-1:0] depth;
    logic [KindW-1:0] kind;
  } color_task_t;
  localparam int unsigned ColorTaskBits = 183;

  typedef struct packed {
    logic signed [DirectionW-1:0] z;
    logic signed [DirectionW-1:0] y;
    logic signed [DirectionW-1:0] x;
  } view_direction_t;
  localparam int unsigned ViewDirectionBits = 54;

  typedef struct packed {
    logic [LengthW-1:0] length2;  // squared length, in units of the view direction
    logic signed [WorldDirectionW-1:0] z;
    logic signed [WorldDirectionW-1:0] y;
    logic signed [WorldDirectionW-1:0] x;
  } world_direction_t;
  localparam int unsigned WorldDirectionBits = 96;

  typedef struct packed {
    logic signed [UnitDirectionW-1:0] z;
    logic signed [UnitDirectionW-1:0] y;
    logic signed [UnitDirectionW-1:0] x;
  } unit_direction_t;
  localparam int unsigned UnitDirectionBits = 54;

  typedef struct packed {
    logic signed [BasisW-1:0] b15;
    logic signed [BasisW-1:0] b14;
    logic signed [BasisW-1:0] b13;
    logic signed [BasisW-1:0] b12;
    logic signed [BasisW-1:0] b11;
    logic signed [BasisW-1:0] b10;
    logic signed [BasisW-1:0] b9;
    logic signed [BasisW-1:0] b8;
    logic signed [BasisW-1:0] b7;
    logic signed [BasisW-1:0] b6;
    logic signed [BasisW-1:0] b5;
    logic signed [BasisW-1:0] b4;
    logic signed [BasisW-1:0] b3;
    logic signed [BasisW-1:0] b2;
    logic signed [BasisW-1:0] b1;  // order and signs of f_rest
  } sh_basis_t;
  localparam int unsigned ShBasisBits = 255;

  typedef struct packed {
    logic [ColorW-1:0] blue;
    logic [ColorW-1:0] green;
    logic [ColorW-1:0] red;
    logic ext;
    logic [AlphaAddressW-1:0] address;
    logic [MaskW-1:0] mask;
    logic [SplatIndexW-1:0] index;
    logic [DepthW-1:0] depth;
    logic [KindW-1:0] kind;
  } colored_t;
  localparam int unsigned ColoredBits = 175;

  typedef struct packed {
    logic signed [LateDefW-1:0] f;
    logic signed [LateDefW-1:0] e;
    logic signed [LateDefW-1:0] d;
    logic signed [LateBcW-1:0] c;
    logic signed [LateBcW-1:0] b;
    logic signed [LateAW-1:0] a;  // Eq. 3, anchored at the part's first pixel
    logic [ColorW-1:0] blue;
    logic [ColorW-1:0] green;
    logic [ColorW-1:0] red;
    logic [MaskW-1:0] mask;
    logic [SplatIndexW-1:0] index;
    logic [PartW-1:0] part;  // of the window, when it has more than one: the mask and Eq. 3 are the part's
    logic [DepthW-1:0] depth;  // of a layer's end when Order is 2: the watermark
    logic [KindW-1:0] kind;
  } splat_t;
  localparam int unsigned SplatBits = 351;

  typedef struct packed {
    logic signed [LateDefW-1:0] f;
    logic signed [LateDefW-1:0] e;
    logic signed [LateDefW-1:0] d;
    logic signed [LateBcW-1:0] c;
    logic signed [LateBcW-1:0] b;
    logic signed [LateAW-1:0] a;
    logic [ColorW-1:0] blue;
    logic [ColorW-1:0] green;
    logic [ColorW-1:0] red;
    logic [MaskW-1:0] mask;
    logic index;
    logic [PartW-1:0] part;
    logic depth;
    logic [KindW-1:0] kind;
  } sorted_t;
  localparam int unsigned SortedBits = 305;

  typedef struct packed {
    logic index;
    logic [ColorW-1:0] blue;
    logic [ColorW-1:0] green;
    logic [ColorW-1:0] red;
    logic [UnitW-1:0] unit;
    logic skip;  // the region is done: its line in the alpha store is freed and not read
    logic ext;
    logic [AlphaAddressW-1:0] address;  // of the line of this region's alphas
    logic [RegionW-1:0] region;
    logic [KindW-1:0] kind;
  } fetch_t;
  localparam int unsigned FetchBits = 75;

  typedef struct packed {
    logic index;
    logic [ColorW-1:0] blue;
    logic [ColorW-1:0] green;
    logic [ColorW-1:0] red;
    logic ext;
    logic [RegionW-1:0] region;
    logic [KindW-1:0] kind;
  } blend_t;
  localparam int unsigned BlendBits = 48;

  typedef struct packed {
    // lines of a read, less one: from `address` on, in one aligned group of eight; 0 for a write
    logic [BurstW-1:0] lines;
    // which 32 bytes of the line a write changes or a read needs, the low ones first; 3 of a read of several lines
    logic [HalvesW-1:0] halves;
    logic [TagW-1:0] tag;  // who asks; reads of one tag answer in order
    logic [AddressW-1:0] address;  // line
    logic write;
  } memory_request_t;
  localparam int unsigned MemoryRequestBits = 45;

  // Stages of a PU on pu_phases: see cpp_model/pu/stages.def.
  localparam int unsigned ProjectDepth   = 6;
  localparam int unsigned ProjectClaim   = 6;
  localparam int unsigned OrientDepth    = 6;
  localparam int unsigned OrientClaim    = 6;
  localparam int unsigned JacobianDepth  = 2;
  localparam int unsigned JacobianClaim  = 2;
  localparam int unsigned FactorsDepth   = 2;
  localparam int unsigned FactorsClaim   = 2;
  localparam int unsigned SquaresDepth   = 3;
  localparam int unsigned SquaresClaim   = 3;
  localparam int unsigned CovarianceDepth = 5;
  localparam int unsigned CovarianceClaim = 5;
  localparam int unsigned AxesDepth      = 7;
  localparam int unsigned AxesClaim      = 7;
  localparam int unsigned BoxDepth       = 5;
  localparam int unsigned BoxClaim       = 7;
  localparam int unsigned ConicDepth     = 11;
  localparam int unsigned ConicClaim     = 14;
  localparam int unsigned CoeffDepth     = 6;
  localparam int unsigned CoeffClaim     = 6;

  // Parts of an overflow area of `size` lines: see cpp_model/areas/areas.hpp.
  localparam logic [2:0] AreaKeys = 3'd0;
  localparam logic [2:0] AreaMerged = 3'd1;
  localparam logic [2:0] AreaRuns = 3'd2;
  localparam logic [2:0] AreaRecords = 3'd3;
  localparam logic [2:0] AreaEven = 3'd4;
  localparam logic [2:0] AreaOdd = 3'd5;
  localparam logic [2:0] AreaLists = 3'd6;
  // lines of it
  function automatic logic [AddressW-1:0] area_lines(input logic [AddressW-1:0] size, input logic [2:0] area);
    case (area)
      AreaKeys: area_lines = size >> 5;
      AreaMerged: area_lines = size >> 5;
      AreaRuns: area_lines = size >> 4;
      AreaRecords: area_lines = size >> 3;
      AreaEven: area_lines = size >> 4;
      AreaOdd: area_lines = size >> 4;
      AreaLists: area_lines = size >> 1;
      default: area_lines = '0;
    endcase
  endfunction
  // its first line, from the first one of its unit's share on
  function automatic logic [AddressW-1:0] area_place(input logic [AddressW-1:0] size, input logic [2:0] area);
    case (area)
      AreaKeys: area_place = '0;
      AreaMerged: area_place = (size >> 5);
      AreaRuns: area_place = (size >> 4);
      AreaRecords: area_place = (size >> 4) << 1;
      AreaEven: area_place = (size >> 4) << 1;
      AreaOdd: area_place = ((size >> 4) << 1) + (size >> 4);
      AreaLists: area_place = '0;
      default: area_place = '0;
    endcase
  endfunction
  // its first line, from the first one of all on; lists have no unit
  function automatic logic [AddressW-1:0] area_first(input logic [AddressW-1:0] size, input logic [UnitW-1:0] unit,
      input logic [2:0] area);
    area_first = (unit[0] ? size >> 2 : '0) + (unit[1] ? (size >> 2) << 1 : '0) +
                 area_place(size, area);
    if (area == AreaLists) area_first = '0;
  endfunction
  // the first line of a window's list, from the first one of all on, where each has 2^log lines
  function automatic logic [AddressW-1:0] list_first(input logic [ListWindowW-1:0] window,
      input logic [$clog2(ListEntryW+1)-1:0] log);
    list_first = (AddressW'(window) << log) + AddressW'(window) * AddressW'(ListGap);
  endfunction

  // Registers of the control side, see package/pipegs_registers.csv: byte offsets.
  localparam int unsigned ControlAddressW = 12;
  localparam logic [ControlAddressW-1:0] ControlControlAt = 12'h010;
  localparam logic [ControlAddressW-1:0] ControlStatusAt = 12'h014;
  localparam logic [ControlAddressW-1:0] ControlErrorAt = 12'h018;
  localparam logic [ControlAddressW-1:0] ControlErrorFirstAt = 12'h01c;
  localparam logic [ControlAddressW-1:0] ControlErrorAddressLowAt = 12'h020;
  localparam logic [ControlAddressW-1:0] ControlErrorAddressHighAt = 12'h024;
  localparam logic [ControlAddressW-1:0] ControlIrqStatusAt = 12'h028;
  localparam logic [ControlAddressW-1:0] ControlIrqEnableAt = 12'h02c;
  localparam logic [ControlAddressW-1:0] ControlFramesStartedAt = 12'h030;
  localparam logic [ControlAddressW-1:0] ControlFramesDoneAt = 12'h034;
  localparam logic [ControlAddressW-1:0] ControlBusTimeoutAt = 12'h038;
  localparam logic [31:0] ControlBusTimeoutReset = 32'h01000000;

  typedef struct packed {  // what the machine is to do
    logic [29:0] gap_0;
    logic abort_all;
    logic start;
  } control_control_t;
  typedef struct packed {  // what the machine does
    logic [27:0] gap_0;
    logic silent;
    logic failed;
    logic queued;
    logic busy;
  } control_status_t;
  typedef struct packed {  // what went wrong since it was cleared
    logic [22:0] gap_0;
    logic start_full;
    logic write_timeout;
    logic read_timeout;
    logic bad_scene;
    logic area_full;
    logic write_decerr;
    logic write_slverr;
    logic read_decerr;
    logic read_slverr;
  } control_error_t;
  typedef struct packed {  // the first error that gave frames up, until ERROR 7:0 is clear
    logic [20:0] gap_1;
    logic [2:0] cause;
    logic [5:0] gap_0;
    logic located;
    logic valid;
  } control_error_first_t;
  typedef struct packed {  // where the first error happened, low word
    logic [31:0] address;
  } control_error_address_low_t;
  typedef struct packed {  // where the first error happened, high word
    logic [31:0] address;
  } control_error_address_high_t;
  typedef struct packed {  // what happened since it was cleared
    logic [28:0] gap_0;
    logic error;
    logic queue_free;
    logic frame_done;
  } control_irq_status_t;
  typedef struct packed {  // which bits of IRQ_STATUS raise the interrupt
    logic [28:0] gap_0;
    logic error;
    logic queue_free;
    logic frame_done;
  } control_irq_enable_t;
  typedef struct packed {  // frames that the machine has taken from the queue
    logic [31:0] count;
  } control_frames_started_t;
  typedef struct packed {  // frames that are complete in memory
    logic [31:0] count;
  } control_frames_done_t;
  typedef struct packed {  // how long memory may be silent
    logic [31:0] cycles;
  } control_bus_timeout_t;

  // Registers that the configuration fixes: {offset of 16 bits, value of 32}.
  localparam int unsigned ControlConstants = 16;
  localparam logic [ControlConstants*48-1:0] ControlConstantTable = {
    48'h00ac_00000100,  // CONFIG_AOVS
    48'h00a8_00000012,  // CONFIG_LESS
    48'h00a4_00040100,  // CONFIG_OVERFLOW
    48'h00a0_00ff4022,  // CONFIG_MEMORY
    48'h009c_0f0d2016,  // CONFIG_LENS
    48'h0098_1c1c141a,  // CONFIG_CAMERA
    48'h0094_10180708,  // CONFIG_NODE
    48'h0090_20101828,  // CONFIG_SCENE
    48'h008c_0c050b0e,  // CONFIG_COLOR
    48'h0088_060c1012,  // CONFIG_GAUSSIAN
    48'h0084_10030e52,  // CONFIG_POINT
    48'h0080_10048004,  // CONFIG_COUNTS
    48'h000c_fcf4ac30,  // CONFIG_HASH
    48'h0008_57b8160a,  // LAYOUT
    48'h0004_00030002,  // VERSION
    48'h0000_47504950  // ID
  };

  typedef struct packed {  // the picture in raster order
    logic [11:0] stride;
    logic [33:0] base;
    logic format;
  } picture_t;
  localparam int unsigned PictureBits = 47;

  // What a start queues: frame_t, areas_t and picture_t in this order, the first one lowest. A slot is {byte
  // offset of its low word (16 bits), lowest bit of its value in what is queued (16), width of the value (8),
  // bit of the slot at which it begins (8), 1 if it is signed (8)}.
  localparam int unsigned ControlShadowBits = 1605;
  localparam int unsigned ControlSlots = 73;
  localparam logic [ControlSlots*56-1:0] ControlSlotTable = {
    56'h0490_0639_0c_06_00,  // stride
    56'h0488_0617_22_06_00,  // base
    56'h0480_0616_01_00_00,  // format
    56'h0438_05f4_22_06_00,  // picture
    56'h0430_05d2_22_06_00,  // overflow
    56'h0428_05b0_22_06_00,  // pixels
    56'h0420_058e_22_06_00,  // colors
    56'h0418_056c_22_06_00,  // gaussians
    56'h0410_054a_22_06_00,  // chunks
    56'h0408_0528_22_06_00,  // groups
    56'h0400_0506_22_06_00,  // cells
    56'h03e8_04ee_18_00_00,  // walk_most
    56'h03e0_04ee_00_00_00,  // lod
    56'h03d8_04ee_00_06_00,  // raster.aovs.lines
    56'h03d0_04ee_00_06_00,  // raster.aovs.base
    56'h03c8_04ee_00_00_00,  // raster.aovs.range
    56'h03c0_04ee_00_00_00,  // raster.aovs.wanted
    56'h03b8_04ee_00_06_00,  // raster.eye_lines
    56'h03b0_04ee_00_00_00,  // raster.eyes
    56'h03a8_04dc_12_00_00,  // raster.rest
    56'h03a0_04d2_0a_00_00,  // raster.windows.last_y
    56'h0398_04c8_0a_00_00,  // raster.windows.last_x
    56'h0390_04be_0a_00_00,  // raster.windows.first_y
    56'h0388_04b4_0a_00_00,  // raster.windows.first_x
    56'h0380_04a5_0f_00_00,  // raster.height
    56'h0378_0496_0f_00_00,  // raster.width
    56'h0370_0474_22_06_00,  // tables.overflow
    56'h0368_0452_22_06_00,  // tables.pixels
    56'h0360_0452_00_00_00,  // tables.antialias
    56'h0358_0450_02_00_00,  // tables.sh_degree
    56'h0350_042e_22_06_00,  // tables.colors
    56'h0348_040c_22_06_00,  // tables.gaussians
    56'h0340_03ea_22_06_00,  // tables.chunks
    56'h0338_03c8_22_06_00,  // tables.groups
    56'h0330_03a6_22_06_00,  // tables.cells
    56'h0328_038a_1c_00_00,  // grid.scale_z
    56'h0320_036e_1c_00_00,  // grid.scale_y
    56'h0318_0352_1c_00_00,  // grid.scale_x
    56'h0310_032a_28_00_01,  // grid.low.z
    56'h0308_0302_28_00_01,  // grid.low.y
    56'h0300_02da_28_00_01,  // grid.low.x
    56'h02f8_02b2_28_00_00,  // lens.near_plane
    56'h02f0_02a5_0d_00_00,  // lens.spread_y
    56'h02e8_0298_0d_00_00,  // lens.spread_x
    56'h02e0_0278_20_00_00,  // lens.reach_y
    56'h02d8_0258_20_00_00,  // lens.reach_x
    56'h02d0_023d_1b_00_00,  // lens.limit_y
    56'h02c8_0222_1b_00_00,  // lens.limit_x
    56'h02c0_0206_1c_00_01,  // lens.center_y
    56'h02b8_01ea_1c_00_01,  // lens.center_x
    56'h02b0_01ce_1c_00_00,  // lens.focal_y
    56'h02a8_01b2_1c_00_00,  // lens.focal_x
    56'h02a0_01b2_00_00_00,  // eyes.reach_y
    56'h0298_01b2_00_00_00,  // eyes.reach_x
    56'h0290_01b2_00_00_00,  // eyes.length
    56'h0288_01b2_00_00_01,  // eyes.half_y
    56'h0280_01b2_00_00_01,  // eyes.half_x
    56'h0278_019e_14_00_01,  // camera.quaternion.z
    56'h0270_018a_14_00_01,  // camera.quaternion.y
    56'h0268_0176_14_00_01,  // camera.quaternion.x
    56'h0260_0162_14_00_01,  // camera.quaternion.w
    56'h0258_0148_1a_00_01,  // camera.rotation.w22
    56'h0250_012e_1a_00_01,  // camera.rotation.w21
    56'h0248_0114_1a_00_01,  // camera.rotation.w20
    56'h0240_00fa_1a_00_01,  // camera.rotation.w12
    56'h0238_00e0_1a_00_01,  // camera.rotation.w11
    56'h0230_00c6_1a_00_01,  // camera.rotation.w10
    56'h0228_00ac_1a_00_01,  // camera.rotation.w02
    56'h0220_0092_1a_00_01,  // camera.rotation.w01
    56'h0218_0078_1a_00_01,  // camera.rotation.w00
    56'h0210_0050_28_00_01,  // camera.position.z
    56'h0208_0028_28_00_01,  // camera.position.y
    56'h0200_0000_28_00_01  // camera.position.x
  };

  // Performance counters: the byte offset of each that this machine has (16 bits), in their order; those of the
  // largest machine lie from begin to end.
  localparam logic [ControlAddressW-1:0] ControlCountersBegin = 12'h600;
  localparam logic [ControlAddressW-1:0] ControlCountersEnd = 12'h940;
  localparam int unsigned ControlCounters = 55;
  localparam logic [ControlCounters*16-1:0] ControlCounterTable = {
    16'h08b8,  // ru3_memory
    16'h08b0,  // ru3_blocked
    16'h08a8,  // ru3_starved
    16'h08a0,  // ru3_busy
    16'h0898,  // ru2_memory
    16'h0890,  // ru2_blocked
    16'h0888,  // ru2_starved
    16'h0880,  // ru2_busy
    16'h0878,  // ru1_memory
    16'h0870,  // ru1_blocked
    16'h0868,  // ru1_starved
    16'h0860,  // ru1_busy
    16'h0858,  // ru0_memory
    16'h0850,  // ru0_blocked
    16'h0848,  // ru0_starved
    16'h0840,  // ru0_busy
    16'h07b8,  // su3_memory
    16'h07b0,  // su3_blocked
    16'h07a8,  // su3_starved
    16'h07a0,  // su3_busy
    16'h0798,  // su2_memory
    16'h0790,  // su2_blocked
    16'h0788,  // su2_starved
    16'h0780,  // su2_busy
    16'h0778,  // su1_memory
    16'h0770,  // su1_blocked
    16'h0768,  // su1_starved
    16'h0760,  // su1_busy
    16'h0758,  // su0_memory
    16'h0750,  // su0_blocked
    16'h0748,  // su0_starved
    16'h0740,  // su0_busy
    16'h06b8,  // pu3_memory
    16'h06b0,  // pu3_blocked
    16'h06a8,  // pu3_starved
    16'h06a0,  // pu3_busy
    16'h0698,  // pu2_memory
    16'h0690,  // pu2_blocked
    16'h0688,  // pu2_starved
    16'h0680,  // pu2_busy
    16'h0678,  // pu1_memory
    16'h0670,  // pu1_blocked
    16'h0668,  // pu1_starved
    16'h0660,  // pu1_busy
    16'h0658,  // pu0_memory
    16'h0650,  // pu0_blocked
    16'h0648,  // pu0_starved
    16'h0640,  // pu0_busy
    16'h0638,  // dopu_memory
    16'h0630,  // dopu_blocked
    16'h0628,  // dopu_starved
    16'h0620,  // dopu_busy
    16'h0610,  // overflow_lines
    16'h0608,  // preprocess_cycles
    16'h0600  // cycles
  };

  // Bundles: wires of all units side by side, the first unit lowest.
  localparam int unsigned ReadPorts = MemoryPorts - WritePorts;
  typedef struct packed {  // ports that only read: geometry of each PU, its colours, then the DOPU
    logic [Units-1:0][HalvesW-1:0] halves;  // of the line of colours, what is needed
    logic [ReadPorts-1:0][BurstW-1:0] lines;  // less one
    logic [ReadPorts-1:0][AddressW-1:0] address;
    logic [ReadPorts-1:0] valid;
  } memory_reads_t;
  typedef struct packed {
    logic [ReadPorts-1:0] line;  // an answer is there
    logic [ReadPorts-1:0] ready;
  } memory_reads_answer_t;

  typedef struct packed {  // one port of each unit that may write
    logic [Units-1:0][MemoryW-1:0] data;
    logic [Units-1:0][AddressW-1:0] address;
    logic [Units-1:0] write;
    logic [Units-1:0] valid;
  } memory_lanes_t;
  typedef struct packed {
    logic [Units-1:0] line;
    logic [Units-1:0] ready;
  } memory_lanes_answer_t;

  typedef struct packed {  // the one port of the lists
    logic [MemoryW-1:0] data;
    logic [BurstW-1:0] lines;  // of a read, less one
    logic [AddressW-1:0] address;
    logic write;
    logic valid;
  } memory_lists_t;
  typedef struct packed {
    logic line;
    logic ready;
  } memory_lists_answer_t;

  typedef struct packed {  // PUs -> their alpha stores
    logic [Units-1:0][LineW-1:0] line;
    logic [Units-1:0][AlphaAddressW-1:0] address;
    logic [Units-1:0] write;
  } store_writes_t;

  typedef struct packed {  // what the RUs have finished, to the front
    logic [Units-1:0][WindowW-1:0] y;  // the window that they are in
    logic [Units-1:0][WindowW-1:0] x;
    logic [Units-1:0][Regions-1:0] done;  // regions of it that need no more alphas
  } progress_t;

  typedef struct packed {  // what the RUs do, for the harness
    logic [Units-1:0][TapLanes*TapWordW-1:0] pixels;
    logic [Units-1:0][TapLanes*2-1:0] pixels_quarter;
    logic [Units-1:0][TapLanes*RegionW-1:0] pixels_region;
    logic [Units-1:0][TapLanes-1:0] pixels_valid;
    logic [Units-1:0][TapLanes*TapLineW-1:0] alphas;
    logic [Units-1:0][TapLanes*2-1:0] alphas_quarter;
    logic [Units-1:0][TapLanes*RegionW-1:0] alphas_region;
    logic [Units-1:0][TapLanes*ShownIndexW-1:0] alphas_index;
    logic [Units-1:0][TapLanes-1:0] alphas_valid;
  } raster_taps_t;

  // AXI4 to memory: its channels, and what manager and subordinate show of reads and of writes.
  localparam int unsigned AxiIdW = TagW + 1;  // the epoch of the core, the tag
  localparam int unsigned AxiAddrW = 64;  // of a byte address; high bits that a manager has not are 0
  localparam int unsigned AxiDataW = BusW == 0 ? MemoryW : BusW;
  localparam logic [3:0] AxiCache = 4'b0010;  // normal, not cached, not buffered: an answer means "in memory"
  localparam logic [2:0] AxiProt = 3'b000;  // unprivileged, secure, data
  localparam logic [1:0] AxiIncr = 2'b01;
  typedef struct packed {  // AR, AW
    logic [AxiIdW-1:0] id;
    logic [AxiAddrW-1:0] addr;
    logic [7:0] len;  // beats, less one
    logic [2:0] size;
    logic [1:0] burst;
    logic [3:0] cache;
    logic [2:0] prot;
  } axi_address_t;
  typedef struct packed {
    logic [AxiIdW-1:0] id;
    logic [AxiDataW-1:0] data;
    logic [1:0] resp;
    logic last;
  } axi_r_t;
  typedef struct packed {
    logic [AxiDataW-1:0] data;
    logic [AxiDataW/8-1:0] strb;
    logic last;
  } axi_w_t;
  typedef struct packed {
    logic [AxiIdW-1:0] id;
    logic [1:0] resp;
  } axi_b_t;
  typedef struct packed {
    axi_address_t ar;
    logic ar_valid;
    logic r_ready;
  } axi_reads_t;
  typedef struct packed {
    logic ar_ready;
    axi_r_t r;
    logic r_valid;
  } axi_reads_answer_t;
  typedef struct packed {
    axi_address_t aw;
    logic aw_valid;
    axi_w_t w;
    logic w_valid;
    logic b_ready;
  } axi_writes_t;
  typedef struct packed {
    logic aw_ready;
    logic w_ready;
    axi_b_t b;
    logic b_valid;
  } axi_writes_answer_t;
  typedef struct packed {
    axi_writes_t write;
    axi_reads_t read;
  } axi_manager_t;
  typedef struct packed {
    axi_writes_answer_t write;
    axi_reads_answer_t read;
  } axi_subordinate_t;

  typedef struct packed {  // what the manager waits for, of reads or of writes
    logic [AddressW-1:0] line;  // of one that is not taken or not answered
    logic located;  // it is known
    logic moves;  // something is taken or answered in this cycle
    logic waits;  // something is not
  } memory_wait_t;

  // AXI4-Lite of the registers, 32 bits, without the protection bits, which nothing looks at.
  typedef struct packed {
    logic [ControlAddressW-1:0] aw_addr;  // byte; its two low bits do not count
    logic aw_valid;
    logic [31:0] w_data;
    logic [3:0] w_strb;
    logic w_valid;
    logic b_ready;
    logic [ControlAddressW-1:0] ar_addr;  // likewise
    logic ar_valid;
    logic r_ready;
  } axi_lite_manager_t;
  typedef struct packed {
    logic aw_ready;
    logic w_ready;
    logic [1:0] b_resp;
    logic b_valid;
    logic ar_ready;
    logic [31:0] r_data;
    logic [1:0] r_resp;
    logic r_valid;
  } axi_lite_subordinate_t;

  typedef struct packed {  // in an SU: an end that waits for what lies before it
    logic all;  // the whole set, not only nearer buckets
    logic [KindW-1:0] kind;
    logic [BucketW-1:0] bucket;
  } su_mark_t;
  typedef struct packed {  // in an SU: slots of one bucket, linked, or an end
    logic [KindW-1:0] kind;
    logic [BucketW-1:0] bucket;
    logic [RecordW-1:0] head;  // the first slot
    logic [RecordW:0] count;
  } su_chain_t;
  typedef struct packed {  // in an SU: keys of a set that spilled come back into the pool
    logic write;
    logic [RecordW-1:0] slot;
    logic [KeyW-1:0] key;
    logic [SlotW-1:0] number;  // its record's, in external memory
    logic read;  // of the key in read_slot
    logic [RecordW-1:0] read_slot;
  } su_external_t;
  typedef struct packed {  // in an SU: such keys, to be sorted in the pool; linked from the last slot to the first
    logic [RecordW:0] count;
    logic [KeyW-1:0] min;
    logic [KeyW-1:0] max;
  } su_group_t;
  typedef struct packed {  // in an SU: a sorted key, or an end with its kind as slot
    logic is_end;
    logic [KeyW-1:0] key;
    logic [RecordW-1:0] slot;
  } su_item_t;

endpackage
