; Problem anywhere-8-19 of the learned domain camera.
; How it came about: anywhere, drawn with seed 20; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
; Cells of 10 mm. A goal is met within 50 mm; goal cells keep inside by what the rounding of 1 motion may take.
(define (problem anywhere-8-19)
  (:domain camera)
  (:objects
    item-01 item-02 - kind-01
    item-03 - kind-wide-11
    item-04 - kind-01
    item-05 - kind-low-narrow-10
    item-06 - kind-01
    item-07 - kind-low-narrow-10
    item-08 - kind-tall-narrow-00
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 start-item-07 start-item-08 goal-item-01 goal-item-02 goal-item-03 goal-item-04 goal-item-05 goal-item-06 goal-item-07 goal-item-08 park-01 park-02 park-03 park-04 park-05 park-06 park-07 park-08 - spot
    m-0000 m-0100a m-0101 m-0111 m-1000 m-1001 m-1011 m-1100 m-1110b m-1111 - motion
    zone1 - zone
    dx-7 dx-6 dx-5 dx-4 dx-2 dx-1 dx3 dx4 dx7 - x-shift
    x00 x01 x02 x03 x04 x05 x06 x07 x08 x09 x10 x11 x12 x13 x14 x15 x16 x17 x18 x19 x20 x21 x22 x23 x24 x25 x26 x27 x28 x29 x30 x31 x32 x33 x34 x35 x36 x37 x38 x39 x40 x41 x42 x43 x44 x45 x46 x47 x48 x49 x50 x51 x52 x53 x54 x55 x56 x57 x58 x59 x60 - x-cell
    dy-7 dy-5 dy-2 dy-1 dy1 dy2 dy3 - y-shift
    y00 y01 y02 y03 y04 y05 y06 y07 y08 y09 y10 y11 y12 y13 y14 y15 y16 y17 y18 y19 y20 y21 y22 y23 y24 y25 y26 y27 y28 y29 y30 y31 y32 y33 y34 y35 y36 y37 y38 y39 y40 y41 y42 y43 y44 y45 y46 y47 y48 y49 y50 y51 y52 y53 y54 y55 y56 y57 y58 y59 y60 - y-cell
    cost7 cost14 cost20 cost23 cost28 cost34 cost46 cost52 cost59 cost66 cost86 - price
    spot-4371-m2603 spot-5607-2048 spot-5872-m1674 spot-5959-22 spot-7872-m616 spot-9067-m1016 - spot)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    (stands item-04 start-item-04) (can-take item-04)
    (stands item-05 start-item-05) (can-take item-05)
    (stands item-06 start-item-06) (can-take item-06)
    (stands item-07 start-item-07) (can-take item-07)
    (stands item-08 start-item-08) (can-take item-08)
    ; goal-item-01 lies at (0.7887, 0.2149) m
    (free goal-item-01)
    ; goal-item-02 lies at (0.9102, -0.1016) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.5607, 0.1978) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 start-item-01) (then item-03 goal-item-03 start-item-01 start-item-02) (then item-03 goal-item-03 start-item-02 nowhere)
    ; goal-item-04 lies at (0.5959, -0.0048) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 nowhere)
    ; goal-item-05 lies at (0.4371, -0.2608) m
    (free goal-item-05)
    (goal-place item-05 goal-item-05) (check item-05 goal-item-05 nowhere)
    ; goal-item-06 lies at (0.4364, 0.0611) m
    (free goal-item-06)
    (goal-place item-06 goal-item-06) (check item-06 goal-item-06 start-item-05) (then item-06 goal-item-06 start-item-05 nowhere)
    ; goal-item-07 lies at (0.5872, -0.1768) m
    (free goal-item-07)
    (goal-place item-07 goal-item-07) (check item-07 goal-item-07 start-item-04) (then item-07 goal-item-07 start-item-04 nowhere)
    ; goal-item-08 lies at (0.7907, -0.0616) m
    (free goal-item-08)
    (goal-place item-08 goal-item-08) (check item-08 goal-item-08 start-item-03) (then item-08 goal-item-08 start-item-03 start-item-07) (then item-08 goal-item-08 start-item-07 nowhere)
    ; park-01 lies at (0.6729, 0.2235) m
    (free park-01)
    (check item-02 park-01 start-item-08) (then item-02 park-01 start-item-08 nowhere)
    (check item-04 park-01 start-item-08) (then item-04 park-01 start-item-08 nowhere)
    (check item-06 park-01 start-item-08) (then item-06 park-01 start-item-08 nowhere)
    ; park-02 lies at (0.4027, -0.1930) m
    (free park-02)
    (check item-05 park-02 start-item-04) (then item-05 park-02 start-item-04 nowhere)
    (check item-07 park-02 start-item-04) (then item-07 park-02 start-item-04 nowhere)
    ; park-03 lies at (0.6633, -0.0975) m
    (free park-03)
    ; park-04 lies at (0.3955, 0.1868) m
    (free park-04)
    (check item-05 park-04 nowhere)
    (check item-07 park-04 start-item-02) (then item-07 park-04 start-item-02 nowhere)
    ; park-05 lies at (0.8750, -0.2229) m
    (free park-05)
    (check item-05 park-05 start-item-03) (then item-05 park-05 start-item-03 nowhere)
    (check item-07 park-05 start-item-03) (then item-07 park-05 start-item-03 nowhere)
    ; park-06 lies at (0.8944, 0.0320) m
    (free park-06)
    (check item-05 park-06 nowhere)
    (check item-07 park-06 nowhere)
    ; park-07 lies at (0.7313, 0.2125) m
    (free park-07)
    (check item-02 park-07 start-item-08) (then item-02 park-07 start-item-08 nowhere)
    (check item-06 park-07 start-item-08) (then item-06 park-07 start-item-08 nowhere)
    ; park-08 lies at (0.6012, -0.2567) m
    (free park-08)
    (check item-05 park-08 nowhere)
    (check item-07 park-08 nowhere)
    (check item-08 park-08 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-02 cost86)
    (can-carry item-03 cost14)
    (can-carry item-04 cost86)
    (can-carry item-05 cost7)
    (can-carry item-06 cost86)
    (can-carry item-07 cost7)
    (can-carry item-08 cost20)
    ; item-01 lies at (0.5937, 0.2407, 0.0180) m at first
    (by-cells item-01) (on-table item-01) (at-x item-01 x24) (at-y item-01 y54) (pushes item-01 m-0101 dx-7 dy-2 cost23) (pushes item-01 m-0111 dx-6 dy1 cost46) (pushes item-01 m-1110b dx-5 dy2 cost59) (pushes item-01 m-1100 dx-1 dy-1 cost28) (pushes item-01 m-1111 dx-4 dy-5 cost66) (pushes item-01 m-0000 dx4 dy1 cost34) (pushes item-01 m-1000 dx7 dy-1 cost52) (pushes item-01 m-1001 dx3 dy-1 cost34) (pushes item-01 m-0100a dx-1 dy3 cost28) (pushes item-01 m-1011 dx-2 dy-7 cost59)
    ; and shall come to (0.7887, 0.2149, 0.0180) m
    (goal-on-table item-01 zone1) (goal-cell item-01 x40 y49 zone1) (goal-cell item-01 x40 y50 zone1) (goal-cell item-01 x40 y51 zone1) (goal-cell item-01 x40 y52 zone1) (goal-cell item-01 x40 y53 zone1) (goal-cell item-01 x41 y48 zone1) (goal-cell item-01 x41 y49 zone1) (goal-cell item-01 x41 y50 zone1) (goal-cell item-01 x41 y51 zone1) (goal-cell item-01 x41 y52 zone1) (goal-cell item-01 x41 y53 zone1) (goal-cell item-01 x41 y54 zone1) (goal-cell item-01 x42 y48 zone1) (goal-cell item-01 x42 y49 zone1) (goal-cell item-01 x42 y50 zone1) (goal-cell item-01 x42 y51 zone1) (goal-cell item-01 x42 y52 zone1) (goal-cell item-01 x42 y53 zone1) (goal-cell item-01 x42 y54 zone1) (goal-cell item-01 x42 y55 zone1) (goal-cell item-01 x43 y47 zone1) (goal-cell item-01 x43 y48 zone1) (goal-cell item-01 x43 y49 zone1) (goal-cell item-01 x43 y50 zone1) (goal-cell item-01 x43 y51 zone1) (goal-cell item-01 x43 y52 zone1) (goal-cell item-01 x43 y53 zone1) (goal-cell item-01 x43 y54 zone1) (goal-cell item-01 x43 y55 zone1) (goal-cell item-01 x44 y47 zone1) (goal-cell item-01 x44 y48 zone1) (goal-cell item-01 x44 y49 zone1) (goal-cell item-01 x44 y50 zone1) (goal-cell item-01 x44 y51 zone1) (goal-cell item-01 x44 y52 zone1) (goal-cell item-01 x44 y53 zone1) (goal-cell item-01 x44 y54 zone1) (goal-cell item-01 x44 y55 zone1) (goal-cell item-01 x45 y48 zone1) (goal-cell item-01 x45 y49 zone1) (goal-cell item-01 x45 y50 zone1) (goal-cell item-01 x45 y51 zone1) (goal-cell item-01 x45 y52 zone1) (goal-cell item-01 x45 y53 zone1) (goal-cell item-01 x45 y54 zone1) (goal-cell item-01 x45 y55 zone1) (goal-cell item-01 x46 y48 zone1) (goal-cell item-01 x46 y49 zone1) (goal-cell item-01 x46 y50 zone1) (goal-cell item-01 x46 y51 zone1) (goal-cell item-01 x46 y52 zone1) (goal-cell item-01 x46 y53 zone1) (goal-cell item-01 x46 y54 zone1) (goal-cell item-01 x47 y49 zone1) (goal-cell item-01 x47 y50 zone1) (goal-cell item-01 x47 y51 zone1) (goal-cell item-01 x47 y52 zone1) (goal-cell item-01 x47 y53 zone1)
    ; where steps lead
    (x-sum dx-7 x07 x00) (x-sum dx-7 x08 x01) (x-sum dx-7 x09 x02) (x-sum dx-7 x10 x03) (x-sum dx-7 x11 x04) (x-sum dx-7 x12 x05) (x-sum dx-7 x13 x06) (x-sum dx-7 x14 x07) (x-sum dx-7 x15 x08) (x-sum dx-7 x16 x09) (x-sum dx-7 x17 x10) (x-sum dx-7 x18 x11) (x-sum dx-7 x19 x12) (x-sum dx-7 x20 x13) (x-sum dx-7 x21 x14) (x-sum dx-7 x22 x15) (x-sum dx-7 x23 x16) (x-sum dx-7 x24 x17) (x-sum dx-7 x25 x18) (x-sum dx-7 x26 x19) (x-sum dx-7 x27 x20) (x-sum dx-7 x28 x21) (x-sum dx-7 x29 x22) (x-sum dx-7 x30 x23) (x-sum dx-7 x31 x24) (x-sum dx-7 x32 x25) (x-sum dx-7 x33 x26) (x-sum dx-7 x34 x27) (x-sum dx-7 x35 x28) (x-sum dx-7 x36 x29) (x-sum dx-7 x37 x30) (x-sum dx-7 x38 x31) (x-sum dx-7 x39 x32) (x-sum dx-7 x40 x33) (x-sum dx-7 x41 x34) (x-sum dx-7 x42 x35) (x-sum dx-7 x43 x36) (x-sum dx-7 x44 x37) (x-sum dx-7 x45 x38) (x-sum dx-7 x46 x39) (x-sum dx-7 x47 x40) (x-sum dx-7 x48 x41) (x-sum dx-7 x49 x42) (x-sum dx-7 x50 x43) (x-sum dx-7 x51 x44) (x-sum dx-7 x52 x45) (x-sum dx-7 x53 x46) (x-sum dx-7 x54 x47) (x-sum dx-7 x55 x48) (x-sum dx-7 x56 x49) (x-sum dx-7 x57 x50) (x-sum dx-7 x58 x51) (x-sum dx-7 x59 x52) (x-sum dx-7 x60 x53)
    (x-sum dx-6 x06 x00) (x-sum dx-6 x07 x01) (x-sum dx-6 x08 x02) (x-sum dx-6 x09 x03) (x-sum dx-6 x10 x04) (x-sum dx-6 x11 x05) (x-sum dx-6 x12 x06) (x-sum dx-6 x13 x07) (x-sum dx-6 x14 x08) (x-sum dx-6 x15 x09) (x-sum dx-6 x16 x10) (x-sum dx-6 x17 x11) (x-sum dx-6 x18 x12) (x-sum dx-6 x19 x13) (x-sum dx-6 x20 x14) (x-sum dx-6 x21 x15) (x-sum dx-6 x22 x16) (x-sum dx-6 x23 x17) (x-sum dx-6 x24 x18) (x-sum dx-6 x25 x19) (x-sum dx-6 x26 x20) (x-sum dx-6 x27 x21) (x-sum dx-6 x28 x22) (x-sum dx-6 x29 x23) (x-sum dx-6 x30 x24) (x-sum dx-6 x31 x25) (x-sum dx-6 x32 x26) (x-sum dx-6 x33 x27) (x-sum dx-6 x34 x28) (x-sum dx-6 x35 x29) (x-sum dx-6 x36 x30) (x-sum dx-6 x37 x31) (x-sum dx-6 x38 x32) (x-sum dx-6 x39 x33) (x-sum dx-6 x40 x34) (x-sum dx-6 x41 x35) (x-sum dx-6 x42 x36) (x-sum dx-6 x43 x37) (x-sum dx-6 x44 x38) (x-sum dx-6 x45 x39) (x-sum dx-6 x46 x40) (x-sum dx-6 x47 x41) (x-sum dx-6 x48 x42) (x-sum dx-6 x49 x43) (x-sum dx-6 x50 x44) (x-sum dx-6 x51 x45) (x-sum dx-6 x52 x46) (x-sum dx-6 x53 x47) (x-sum dx-6 x54 x48) (x-sum dx-6 x55 x49) (x-sum dx-6 x56 x50) (x-sum dx-6 x57 x51) (x-sum dx-6 x58 x52) (x-sum dx-6 x59 x53) (x-sum dx-6 x60 x54)
    (x-sum dx-5 x05 x00) (x-sum dx-5 x06 x01) (x-sum dx-5 x07 x02) (x-sum dx-5 x08 x03) (x-sum dx-5 x09 x04) (x-sum dx-5 x10 x05) (x-sum dx-5 x11 x06) (x-sum dx-5 x12 x07) (x-sum dx-5 x13 x08) (x-sum dx-5 x14 x09) (x-sum dx-5 x15 x10) (x-sum dx-5 x16 x11) (x-sum dx-5 x17 x12) (x-sum dx-5 x18 x13) (x-sum dx-5 x19 x14) (x-sum dx-5 x20 x15) (x-sum dx-5 x21 x16) (x-sum dx-5 x22 x17) (x-sum dx-5 x23 x18) (x-sum dx-5 x24 x19) (x-sum dx-5 x25 x20) (x-sum dx-5 x26 x21) (x-sum dx-5 x27 x22) (x-sum dx-5 x28 x23) (x-sum dx-5 x29 x24) (x-sum dx-5 x30 x25) (x-sum dx-5 x31 x26) (x-sum dx-5 x32 x27) (x-sum dx-5 x33 x28) (x-sum dx-5 x34 x29) (x-sum dx-5 x35 x30) (x-sum dx-5 x36 x31) (x-sum dx-5 x37 x32) (x-sum dx-5 x38 x33) (x-sum dx-5 x39 x34) (x-sum dx-5 x40 x35) (x-sum dx-5 x41 x36) (x-sum dx-5 x42 x37) (x-sum dx-5 x43 x38) (x-sum dx-5 x44 x39) (x-sum dx-5 x45 x40) (x-sum dx-5 x46 x41) (x-sum dx-5 x47 x42) (x-sum dx-5 x48 x43) (x-sum dx-5 x49 x44) (x-sum dx-5 x50 x45) (x-sum dx-5 x51 x46) (x-sum dx-5 x52 x47) (x-sum dx-5 x53 x48) (x-sum dx-5 x54 x49) (x-sum dx-5 x55 x50) (x-sum dx-5 x56 x51) (x-sum dx-5 x57 x52) (x-sum dx-5 x58 x53) (x-sum dx-5 x59 x54) (x-sum dx-5 x60 x55)
    (x-sum dx-4 x04 x00) (x-sum dx-4 x05 x01) (x-sum dx-4 x06 x02) (x-sum dx-4 x07 x03) (x-sum dx-4 x08 x04) (x-sum dx-4 x09 x05) (x-sum dx-4 x10 x06) (x-sum dx-4 x11 x07) (x-sum dx-4 x12 x08) (x-sum dx-4 x13 x09) (x-sum dx-4 x14 x10) (x-sum dx-4 x15 x11) (x-sum dx-4 x16 x12) (x-sum dx-4 x17 x13) (x-sum dx-4 x18 x14) (x-sum dx-4 x19 x15) (x-sum dx-4 x20 x16) (x-sum dx-4 x21 x17) (x-sum dx-4 x22 x18) (x-sum dx-4 x23 x19) (x-sum dx-4 x24 x20) (x-sum dx-4 x25 x21) (x-sum dx-4 x26 x22) (x-sum dx-4 x27 x23) (x-sum dx-4 x28 x24) (x-sum dx-4 x29 x25) (x-sum dx-4 x30 x26) (x-sum dx-4 x31 x27) (x-sum dx-4 x32 x28) (x-sum dx-4 x33 x29) (x-sum dx-4 x34 x30) (x-sum dx-4 x35 x31) (x-sum dx-4 x36 x32) (x-sum dx-4 x37 x33) (x-sum dx-4 x38 x34) (x-sum dx-4 x39 x35) (x-sum dx-4 x40 x36) (x-sum dx-4 x41 x37) (x-sum dx-4 x42 x38) (x-sum dx-4 x43 x39) (x-sum dx-4 x44 x40) (x-sum dx-4 x45 x41) (x-sum dx-4 x46 x42) (x-sum dx-4 x47 x43) (x-sum dx-4 x48 x44) (x-sum dx-4 x49 x45) (x-sum dx-4 x50 x46) (x-sum dx-4 x51 x47) (x-sum dx-4 x52 x48) (x-sum dx-4 x53 x49) (x-sum dx-4 x54 x50) (x-sum dx-4 x55 x51) (x-sum dx-4 x56 x52) (x-sum dx-4 x57 x53) (x-sum dx-4 x58 x54) (x-sum dx-4 x59 x55) (x-sum dx-4 x60 x56)
    (x-sum dx-2 x02 x00) (x-sum dx-2 x03 x01) (x-sum dx-2 x04 x02) (x-sum dx-2 x05 x03) (x-sum dx-2 x06 x04) (x-sum dx-2 x07 x05) (x-sum dx-2 x08 x06) (x-sum dx-2 x09 x07) (x-sum dx-2 x10 x08) (x-sum dx-2 x11 x09) (x-sum dx-2 x12 x10) (x-sum dx-2 x13 x11) (x-sum dx-2 x14 x12) (x-sum dx-2 x15 x13) (x-sum dx-2 x16 x14) (x-sum dx-2 x17 x15) (x-sum dx-2 x18 x16) (x-sum dx-2 x19 x17) (x-sum dx-2 x20 x18) (x-sum dx-2 x21 x19) (x-sum dx-2 x22 x20) (x-sum dx-2 x23 x21) (x-sum dx-2 x24 x22) (x-sum dx-2 x25 x23) (x-sum dx-2 x26 x24) (x-sum dx-2 x27 x25) (x-sum dx-2 x28 x26) (x-sum dx-2 x29 x27) (x-sum dx-2 x30 x28) (x-sum dx-2 x31 x29) (x-sum dx-2 x32 x30) (x-sum dx-2 x33 x31) (x-sum dx-2 x34 x32) (x-sum dx-2 x35 x33) (x-sum dx-2 x36 x34) (x-sum dx-2 x37 x35) (x-sum dx-2 x38 x36) (x-sum dx-2 x39 x37) (x-sum dx-2 x40 x38) (x-sum dx-2 x41 x39) (x-sum dx-2 x42 x40) (x-sum dx-2 x43 x41) (x-sum dx-2 x44 x42) (x-sum dx-2 x45 x43) (x-sum dx-2 x46 x44) (x-sum dx-2 x47 x45) (x-sum dx-2 x48 x46) (x-sum dx-2 x49 x47) (x-sum dx-2 x50 x48) (x-sum dx-2 x51 x49) (x-sum dx-2 x52 x50) (x-sum dx-2 x53 x51) (x-sum dx-2 x54 x52) (x-sum dx-2 x55 x53) (x-sum dx-2 x56 x54) (x-sum dx-2 x57 x55) (x-sum dx-2 x58 x56) (x-sum dx-2 x59 x57) (x-sum dx-2 x60 x58)
    (x-sum dx-1 x01 x00) (x-sum dx-1 x02 x01) (x-sum dx-1 x03 x02) (x-sum dx-1 x04 x03) (x-sum dx-1 x05 x04) (x-sum dx-1 x06 x05) (x-sum dx-1 x07 x06) (x-sum dx-1 x08 x07) (x-sum dx-1 x09 x08) (x-sum dx-1 x10 x09) (x-sum dx-1 x11 x10) (x-sum dx-1 x12 x11) (x-sum dx-1 x13 x12) (x-sum dx-1 x14 x13) (x-sum dx-1 x15 x14) (x-sum dx-1 x16 x15) (x-sum dx-1 x17 x16) (x-sum dx-1 x18 x17) (x-sum dx-1 x19 x18) (x-sum dx-1 x20 x19) (x-sum dx-1 x21 x20) (x-sum dx-1 x22 x21) (x-sum dx-1 x23 x22) (x-sum dx-1 x24 x23) (x-sum dx-1 x25 x24) (x-sum dx-1 x26 x25) (x-sum dx-1 x27 x26) (x-sum dx-1 x28 x27) (x-sum dx-1 x29 x28) (x-sum dx-1 x30 x29) (x-sum dx-1 x31 x30) (x-sum dx-1 x32 x31) (x-sum dx-1 x33 x32) (x-sum dx-1 x34 x33) (x-sum dx-1 x35 x34) (x-sum dx-1 x36 x35) (x-sum dx-1 x37 x36) (x-sum dx-1 x38 x37) (x-sum dx-1 x39 x38) (x-sum dx-1 x40 x39) (x-sum dx-1 x41 x40) (x-sum dx-1 x42 x41) (x-sum dx-1 x43 x42) (x-sum dx-1 x44 x43) (x-sum dx-1 x45 x44) (x-sum dx-1 x46 x45) (x-sum dx-1 x47 x46) (x-sum dx-1 x48 x47) (x-sum dx-1 x49 x48) (x-sum dx-1 x50 x49) (x-sum dx-1 x51 x50) (x-sum dx-1 x52 x51) (x-sum dx-1 x53 x52) (x-sum dx-1 x54 x53) (x-sum dx-1 x55 x54) (x-sum dx-1 x56 x55) (x-sum dx-1 x57 x56) (x-sum dx-1 x58 x57) (x-sum dx-1 x59 x58) (x-sum dx-1 x60 x59)
    (x-sum dx3 x00 x03) (x-sum dx3 x01 x04) (x-sum dx3 x02 x05) (x-sum dx3 x03 x06) (x-sum dx3 x04 x07) (x-sum dx3 x05 x08) (x-sum dx3 x06 x09) (x-sum dx3 x07 x10) (x-sum dx3 x08 x11) (x-sum dx3 x09 x12) (x-sum dx3 x10 x13) (x-sum dx3 x11 x14) (x-sum dx3 x12 x15) (x-sum dx3 x13 x16) (x-sum dx3 x14 x17) (x-sum dx3 x15 x18) (x-sum dx3 x16 x19) (x-sum dx3 x17 x20) (x-sum dx3 x18 x21) (x-sum dx3 x19 x22) (x-sum dx3 x20 x23) (x-sum dx3 x21 x24) (x-sum dx3 x22 x25) (x-sum dx3 x23 x26) (x-sum dx3 x24 x27) (x-sum dx3 x25 x28) (x-sum dx3 x26 x29) (x-sum dx3 x27 x30) (x-sum dx3 x28 x31) (x-sum dx3 x29 x32) (x-sum dx3 x30 x33) (x-sum dx3 x31 x34) (x-sum dx3 x32 x35) (x-sum dx3 x33 x36) (x-sum dx3 x34 x37) (x-sum dx3 x35 x38) (x-sum dx3 x36 x39) (x-sum dx3 x37 x40) (x-sum dx3 x38 x41) (x-sum dx3 x39 x42) (x-sum dx3 x40 x43) (x-sum dx3 x41 x44) (x-sum dx3 x42 x45) (x-sum dx3 x43 x46) (x-sum dx3 x44 x47) (x-sum dx3 x45 x48) (x-sum dx3 x46 x49) (x-sum dx3 x47 x50) (x-sum dx3 x48 x51) (x-sum dx3 x49 x52) (x-sum dx3 x50 x53) (x-sum dx3 x51 x54) (x-sum dx3 x52 x55) (x-sum dx3 x53 x56) (x-sum dx3 x54 x57) (x-sum dx3 x55 x58) (x-sum dx3 x56 x59) (x-sum dx3 x57 x60)
    (x-sum dx4 x00 x04) (x-sum dx4 x01 x05) (x-sum dx4 x02 x06) (x-sum dx4 x03 x07) (x-sum dx4 x04 x08) (x-sum dx4 x05 x09) (x-sum dx4 x06 x10) (x-sum dx4 x07 x11) (x-sum dx4 x08 x12) (x-sum dx4 x09 x13) (x-sum dx4 x10 x14) (x-sum dx4 x11 x15) (x-sum dx4 x12 x16) (x-sum dx4 x13 x17) (x-sum dx4 x14 x18) (x-sum dx4 x15 x19) (x-sum dx4 x16 x20) (x-sum dx4 x17 x21) (x-sum dx4 x18 x22) (x-sum dx4 x19 x23) (x-sum dx4 x20 x24) (x-sum dx4 x21 x25) (x-sum dx4 x22 x26) (x-sum dx4 x23 x27) (x-sum dx4 x24 x28) (x-sum dx4 x25 x29) (x-sum dx4 x26 x30) (x-sum dx4 x27 x31) (x-sum dx4 x28 x32) (x-sum dx4 x29 x33) (x-sum dx4 x30 x34) (x-sum dx4 x31 x35) (x-sum dx4 x32 x36) (x-sum dx4 x33 x37) (x-sum dx4 x34 x38) (x-sum dx4 x35 x39) (x-sum dx4 x36 x40) (x-sum dx4 x37 x41) (x-sum dx4 x38 x42) (x-sum dx4 x39 x43) (x-sum dx4 x40 x44) (x-sum dx4 x41 x45) (x-sum dx4 x42 x46) (x-sum dx4 x43 x47) (x-sum dx4 x44 x48) (x-sum dx4 x45 x49) (x-sum dx4 x46 x50) (x-sum dx4 x47 x51) (x-sum dx4 x48 x52) (x-sum dx4 x49 x53) (x-sum dx4 x50 x54) (x-sum dx4 x51 x55) (x-sum dx4 x52 x56) (x-sum dx4 x53 x57) (x-sum dx4 x54 x58) (x-sum dx4 x55 x59) (x-sum dx4 x56 x60)
    (x-sum dx7 x00 x07) (x-sum dx7 x01 x08) (x-sum dx7 x02 x09) (x-sum dx7 x03 x10) (x-sum dx7 x04 x11) (x-sum dx7 x05 x12) (x-sum dx7 x06 x13) (x-sum dx7 x07 x14) (x-sum dx7 x08 x15) (x-sum dx7 x09 x16) (x-sum dx7 x10 x17) (x-sum dx7 x11 x18) (x-sum dx7 x12 x19) (x-sum dx7 x13 x20) (x-sum dx7 x14 x21) (x-sum dx7 x15 x22) (x-sum dx7 x16 x23) (x-sum dx7 x17 x24) (x-sum dx7 x18 x25) (x-sum dx7 x19 x26) (x-sum dx7 x20 x27) (x-sum dx7 x21 x28) (x-sum dx7 x22 x29) (x-sum dx7 x23 x30) (x-sum dx7 x24 x31) (x-sum dx7 x25 x32) (x-sum dx7 x26 x33) (x-sum dx7 x27 x34) (x-sum dx7 x28 x35) (x-sum dx7 x29 x36) (x-sum dx7 x30 x37) (x-sum dx7 x31 x38) (x-sum dx7 x32 x39) (x-sum dx7 x33 x40) (x-sum dx7 x34 x41) (x-sum dx7 x35 x42) (x-sum dx7 x36 x43) (x-sum dx7 x37 x44) (x-sum dx7 x38 x45) (x-sum dx7 x39 x46) (x-sum dx7 x40 x47) (x-sum dx7 x41 x48) (x-sum dx7 x42 x49) (x-sum dx7 x43 x50) (x-sum dx7 x44 x51) (x-sum dx7 x45 x52) (x-sum dx7 x46 x53) (x-sum dx7 x47 x54) (x-sum dx7 x48 x55) (x-sum dx7 x49 x56) (x-sum dx7 x50 x57) (x-sum dx7 x51 x58) (x-sum dx7 x52 x59) (x-sum dx7 x53 x60)
    (y-sum dy-7 y07 y00) (y-sum dy-7 y08 y01) (y-sum dy-7 y09 y02) (y-sum dy-7 y10 y03) (y-sum dy-7 y11 y04) (y-sum dy-7 y12 y05) (y-sum dy-7 y13 y06) (y-sum dy-7 y14 y07) (y-sum dy-7 y15 y08) (y-sum dy-7 y16 y09) (y-sum dy-7 y17 y10) (y-sum dy-7 y18 y11) (y-sum dy-7 y19 y12) (y-sum dy-7 y20 y13) (y-sum dy-7 y21 y14) (y-sum dy-7 y22 y15) (y-sum dy-7 y23 y16) (y-sum dy-7 y24 y17) (y-sum dy-7 y25 y18) (y-sum dy-7 y26 y19) (y-sum dy-7 y27 y20) (y-sum dy-7 y28 y21) (y-sum dy-7 y29 y22) (y-sum dy-7 y30 y23) (y-sum dy-7 y31 y24) (y-sum dy-7 y32 y25) (y-sum dy-7 y33 y26) (y-sum dy-7 y34 y27) (y-sum dy-7 y35 y28) (y-sum dy-7 y36 y29) (y-sum dy-7 y37 y30) (y-sum dy-7 y38 y31) (y-sum dy-7 y39 y32) (y-sum dy-7 y40 y33) (y-sum dy-7 y41 y34) (y-sum dy-7 y42 y35) (y-sum dy-7 y43 y36) (y-sum dy-7 y44 y37) (y-sum dy-7 y45 y38) (y-sum dy-7 y46 y39) (y-sum dy-7 y47 y40) (y-sum dy-7 y48 y41) (y-sum dy-7 y49 y42) (y-sum dy-7 y50 y43) (y-sum dy-7 y51 y44) (y-sum dy-7 y52 y45) (y-sum dy-7 y53 y46) (y-sum dy-7 y54 y47) (y-sum dy-7 y55 y48) (y-sum dy-7 y56 y49) (y-sum dy-7 y57 y50) (y-sum dy-7 y58 y51) (y-sum dy-7 y59 y52) (y-sum dy-7 y60 y53)
    (y-sum dy-5 y05 y00) (y-sum dy-5 y06 y01) (y-sum dy-5 y07 y02) (y-sum dy-5 y08 y03) (y-sum dy-5 y09 y04) (y-sum dy-5 y10 y05) (y-sum dy-5 y11 y06) (y-sum dy-5 y12 y07) (y-sum dy-5 y13 y08) (y-sum dy-5 y14 y09) (y-sum dy-5 y15 y10) (y-sum dy-5 y16 y11) (y-sum dy-5 y17 y12) (y-sum dy-5 y18 y13) (y-sum dy-5 y19 y14) (y-sum dy-5 y20 y15) (y-sum dy-5 y21 y16) (y-sum dy-5 y22 y17) (y-sum dy-5 y23 y18) (y-sum dy-5 y24 y19) (y-sum dy-5 y25 y20) (y-sum dy-5 y26 y21) (y-sum dy-5 y27 y22) (y-sum dy-5 y28 y23) (y-sum dy-5 y29 y24) (y-sum dy-5 y30 y25) (y-sum dy-5 y31 y26) (y-sum dy-5 y32 y27) (y-sum dy-5 y33 y28) (y-sum dy-5 y34 y29) (y-sum dy-5 y35 y30) (y-sum dy-5 y36 y31) (y-sum dy-5 y37 y32) (y-sum dy-5 y38 y33) (y-sum dy-5 y39 y34) (y-sum dy-5 y40 y35) (y-sum dy-5 y41 y36) (y-sum dy-5 y42 y37) (y-sum dy-5 y43 y38) (y-sum dy-5 y44 y39) (y-sum dy-5 y45 y40) (y-sum dy-5 y46 y41) (y-sum dy-5 y47 y42) (y-sum dy-5 y48 y43) (y-sum dy-5 y49 y44) (y-sum dy-5 y50 y45) (y-sum dy-5 y51 y46) (y-sum dy-5 y52 y47) (y-sum dy-5 y53 y48) (y-sum dy-5 y54 y49) (y-sum dy-5 y55 y50) (y-sum dy-5 y56 y51) (y-sum dy-5 y57 y52) (y-sum dy-5 y58 y53) (y-sum dy-5 y59 y54) (y-sum dy-5 y60 y55)
    (y-sum dy-2 y02 y00) (y-sum dy-2 y03 y01) (y-sum dy-2 y04 y02) (y-sum dy-2 y05 y03) (y-sum dy-2 y06 y04) (y-sum dy-2 y07 y05) (y-sum dy-2 y08 y06) (y-sum dy-2 y09 y07) (y-sum dy-2 y10 y08) (y-sum dy-2 y11 y09) (y-sum dy-2 y12 y10) (y-sum dy-2 y13 y11) (y-sum dy-2 y14 y12) (y-sum dy-2 y15 y13) (y-sum dy-2 y16 y14) (y-sum dy-2 y17 y15) (y-sum dy-2 y18 y16) (y-sum dy-2 y19 y17) (y-sum dy-2 y20 y18) (y-sum dy-2 y21 y19) (y-sum dy-2 y22 y20) (y-sum dy-2 y23 y21) (y-sum dy-2 y24 y22) (y-sum dy-2 y25 y23) (y-sum dy-2 y26 y24) (y-sum dy-2 y27 y25) (y-sum dy-2 y28 y26) (y-sum dy-2 y29 y27) (y-sum dy-2 y30 y28) (y-sum dy-2 y31 y29) (y-sum dy-2 y32 y30) (y-sum dy-2 y33 y31) (y-sum dy-2 y34 y32) (y-sum dy-2 y35 y33) (y-sum dy-2 y36 y34) (y-sum dy-2 y37 y35) (y-sum dy-2 y38 y36) (y-sum dy-2 y39 y37) (y-sum dy-2 y40 y38) (y-sum dy-2 y41 y39) (y-sum dy-2 y42 y40) (y-sum dy-2 y43 y41) (y-sum dy-2 y44 y42) (y-sum dy-2 y45 y43) (y-sum dy-2 y46 y44) (y-sum dy-2 y47 y45) (y-sum dy-2 y48 y46) (y-sum dy-2 y49 y47) (y-sum dy-2 y50 y48) (y-sum dy-2 y51 y49) (y-sum dy-2 y52 y50) (y-sum dy-2 y53 y51) (y-sum dy-2 y54 y52) (y-sum dy-2 y55 y53) (y-sum dy-2 y56 y54) (y-sum dy-2 y57 y55) (y-sum dy-2 y58 y56) (y-sum dy-2 y59 y57) (y-sum dy-2 y60 y58)
    (y-sum dy-1 y01 y00) (y-sum dy-1 y02 y01) (y-sum dy-1 y03 y02) (y-sum dy-1 y04 y03) (y-sum dy-1 y05 y04) (y-sum dy-1 y06 y05) (y-sum dy-1 y07 y06) (y-sum dy-1 y08 y07) (y-sum dy-1 y09 y08) (y-sum dy-1 y10 y09) (y-sum dy-1 y11 y10) (y-sum dy-1 y12 y11) (y-sum dy-1 y13 y12) (y-sum dy-1 y14 y13) (y-sum dy-1 y15 y14) (y-sum dy-1 y16 y15) (y-sum dy-1 y17 y16) (y-sum dy-1 y18 y17) (y-sum dy-1 y19 y18) (y-sum dy-1 y20 y19) (y-sum dy-1 y21 y20) (y-sum dy-1 y22 y21) (y-sum dy-1 y23 y22) (y-sum dy-1 y24 y23) (y-sum dy-1 y25 y24) (y-sum dy-1 y26 y25) (y-sum dy-1 y27 y26) (y-sum dy-1 y28 y27) (y-sum dy-1 y29 y28) (y-sum dy-1 y30 y29) (y-sum dy-1 y31 y30) (y-sum dy-1 y32 y31) (y-sum dy-1 y33 y32) (y-sum dy-1 y34 y33) (y-sum dy-1 y35 y34) (y-sum dy-1 y36 y35) (y-sum dy-1 y37 y36) (y-sum dy-1 y38 y37) (y-sum dy-1 y39 y38) (y-sum dy-1 y40 y39) (y-sum dy-1 y41 y40) (y-sum dy-1 y42 y41) (y-sum dy-1 y43 y42) (y-sum dy-1 y44 y43) (y-sum dy-1 y45 y44) (y-sum dy-1 y46 y45) (y-sum dy-1 y47 y46) (y-sum dy-1 y48 y47) (y-sum dy-1 y49 y48) (y-sum dy-1 y50 y49) (y-sum dy-1 y51 y50) (y-sum dy-1 y52 y51) (y-sum dy-1 y53 y52) (y-sum dy-1 y54 y53) (y-sum dy-1 y55 y54) (y-sum dy-1 y56 y55) (y-sum dy-1 y57 y56) (y-sum dy-1 y58 y57) (y-sum dy-1 y59 y58) (y-sum dy-1 y60 y59)
    (y-sum dy1 y00 y01) (y-sum dy1 y01 y02) (y-sum dy1 y02 y03) (y-sum dy1 y03 y04) (y-sum dy1 y04 y05) (y-sum dy1 y05 y06) (y-sum dy1 y06 y07) (y-sum dy1 y07 y08) (y-sum dy1 y08 y09) (y-sum dy1 y09 y10) (y-sum dy1 y10 y11) (y-sum dy1 y11 y12) (y-sum dy1 y12 y13) (y-sum dy1 y13 y14) (y-sum dy1 y14 y15) (y-sum dy1 y15 y16) (y-sum dy1 y16 y17) (y-sum dy1 y17 y18) (y-sum dy1 y18 y19) (y-sum dy1 y19 y20) (y-sum dy1 y20 y21) (y-sum dy1 y21 y22) (y-sum dy1 y22 y23) (y-sum dy1 y23 y24) (y-sum dy1 y24 y25) (y-sum dy1 y25 y26) (y-sum dy1 y26 y27) (y-sum dy1 y27 y28) (y-sum dy1 y28 y29) (y-sum dy1 y29 y30) (y-sum dy1 y30 y31) (y-sum dy1 y31 y32) (y-sum dy1 y32 y33) (y-sum dy1 y33 y34) (y-sum dy1 y34 y35) (y-sum dy1 y35 y36) (y-sum dy1 y36 y37) (y-sum dy1 y37 y38) (y-sum dy1 y38 y39) (y-sum dy1 y39 y40) (y-sum dy1 y40 y41) (y-sum dy1 y41 y42) (y-sum dy1 y42 y43) (y-sum dy1 y43 y44) (y-sum dy1 y44 y45) (y-sum dy1 y45 y46) (y-sum dy1 y46 y47) (y-sum dy1 y47 y48) (y-sum dy1 y48 y49) (y-sum dy1 y49 y50) (y-sum dy1 y50 y51) (y-sum dy1 y51 y52) (y-sum dy1 y52 y53) (y-sum dy1 y53 y54) (y-sum dy1 y54 y55) (y-sum dy1 y55 y56) (y-sum dy1 y56 y57) (y-sum dy1 y57 y58) (y-sum dy1 y58 y59) (y-sum dy1 y59 y60)
    (y-sum dy2 y00 y02) (y-sum dy2 y01 y03) (y-sum dy2 y02 y04) (y-sum dy2 y03 y05) (y-sum dy2 y04 y06) (y-sum dy2 y05 y07) (y-sum dy2 y06 y08) (y-sum dy2 y07 y09) (y-sum dy2 y08 y10) (y-sum dy2 y09 y11) (y-sum dy2 y10 y12) (y-sum dy2 y11 y13) (y-sum dy2 y12 y14) (y-sum dy2 y13 y15) (y-sum dy2 y14 y16) (y-sum dy2 y15 y17) (y-sum dy2 y16 y18) (y-sum dy2 y17 y19) (y-sum dy2 y18 y20) (y-sum dy2 y19 y21) (y-sum dy2 y20 y22) (y-sum dy2 y21 y23) (y-sum dy2 y22 y24) (y-sum dy2 y23 y25) (y-sum dy2 y24 y26) (y-sum dy2 y25 y27) (y-sum dy2 y26 y28) (y-sum dy2 y27 y29) (y-sum dy2 y28 y30) (y-sum dy2 y29 y31) (y-sum dy2 y30 y32) (y-sum dy2 y31 y33) (y-sum dy2 y32 y34) (y-sum dy2 y33 y35) (y-sum dy2 y34 y36) (y-sum dy2 y35 y37) (y-sum dy2 y36 y38) (y-sum dy2 y37 y39) (y-sum dy2 y38 y40) (y-sum dy2 y39 y41) (y-sum dy2 y40 y42) (y-sum dy2 y41 y43) (y-sum dy2 y42 y44) (y-sum dy2 y43 y45) (y-sum dy2 y44 y46) (y-sum dy2 y45 y47) (y-sum dy2 y46 y48) (y-sum dy2 y47 y49) (y-sum dy2 y48 y50) (y-sum dy2 y49 y51) (y-sum dy2 y50 y52) (y-sum dy2 y51 y53) (y-sum dy2 y52 y54) (y-sum dy2 y53 y55) (y-sum dy2 y54 y56) (y-sum dy2 y55 y57) (y-sum dy2 y56 y58) (y-sum dy2 y57 y59) (y-sum dy2 y58 y60)
    (y-sum dy3 y00 y03) (y-sum dy3 y01 y04) (y-sum dy3 y02 y05) (y-sum dy3 y03 y06) (y-sum dy3 y04 y07) (y-sum dy3 y05 y08) (y-sum dy3 y06 y09) (y-sum dy3 y07 y10) (y-sum dy3 y08 y11) (y-sum dy3 y09 y12) (y-sum dy3 y10 y13) (y-sum dy3 y11 y14) (y-sum dy3 y12 y15) (y-sum dy3 y13 y16) (y-sum dy3 y14 y17) (y-sum dy3 y15 y18) (y-sum dy3 y16 y19) (y-sum dy3 y17 y20) (y-sum dy3 y18 y21) (y-sum dy3 y19 y22) (y-sum dy3 y20 y23) (y-sum dy3 y21 y24) (y-sum dy3 y22 y25) (y-sum dy3 y23 y26) (y-sum dy3 y24 y27) (y-sum dy3 y25 y28) (y-sum dy3 y26 y29) (y-sum dy3 y27 y30) (y-sum dy3 y28 y31) (y-sum dy3 y29 y32) (y-sum dy3 y30 y33) (y-sum dy3 y31 y34) (y-sum dy3 y32 y35) (y-sum dy3 y33 y36) (y-sum dy3 y34 y37) (y-sum dy3 y35 y38) (y-sum dy3 y36 y39) (y-sum dy3 y37 y40) (y-sum dy3 y38 y41) (y-sum dy3 y39 y42) (y-sum dy3 y40 y43) (y-sum dy3 y41 y44) (y-sum dy3 y42 y45) (y-sum dy3 y43 y46) (y-sum dy3 y44 y47) (y-sum dy3 y45 y48) (y-sum dy3 y46 y49) (y-sum dy3 y47 y50) (y-sum dy3 y48 y51) (y-sum dy3 y49 y52) (y-sum dy3 y50 y53) (y-sum dy3 y51 y54) (y-sum dy3 y52 y55) (y-sum dy3 y53 y56) (y-sum dy3 y54 y57) (y-sum dy3 y55 y58) (y-sum dy3 y56 y59) (y-sum dy3 y57 y60)
    ; for plans beside this problem, which the exact replay takes
    (check item-02 spot-9067-m1016 nowhere)
    (check item-03 spot-5607-2048 start-item-01)
    (check item-04 spot-5959-22 nowhere)
    (check item-05 spot-4371-m2603 nowhere)
    (check item-07 spot-5872-m1674 start-item-04)
    (check item-08 spot-7872-m616 start-item-03)
    (free spot-4371-m2603)
    (free spot-5607-2048)
    (free spot-5872-m1674)
    (free spot-5959-22)
    (free spot-7872-m616)
    (free spot-9067-m1016)
    (goal-cell item-01 x38 y53 zone1)
    (goal-place item-02 spot-9067-m1016)
    (goal-place item-03 spot-5607-2048)
    (goal-place item-04 spot-5959-22)
    (goal-place item-05 spot-4371-m2603)
    (goal-place item-07 spot-5872-m1674)
    (goal-place item-08 spot-7872-m616)
    (then item-03 spot-5607-2048 start-item-01 start-item-02) (then item-03 spot-5607-2048 start-item-02 nowhere)
    (then item-07 spot-5872-m1674 start-item-04 nowhere)
    (then item-08 spot-7872-m616 start-item-03 start-item-07) (then item-08 spot-7872-m616 start-item-07 nowhere)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost14) 14) (= (cost cost20) 20) (= (cost cost23) 23) (= (cost cost28) 28) (= (cost cost34) 34) (= (cost cost46) 46) (= (cost cost52) 52) (= (cost cost59) 59) (= (cost cost66) 66) (= (cost cost86) 86)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04) (done item-05) (done item-06) (done item-07) (done item-08)))
  (:metric minimize (total-cost)))
