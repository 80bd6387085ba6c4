; Problem task-01 of the learned domain tabletop, in numbers.
; How it came about: drawn with seed 2: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-01)
  (:domain tabletop-numeric)
  (:objects
    item-01 - solid-00
    m-0100a-item-01 m-0110a-item-01 m-0111a-item-01 m-1111a-item-01 m-0000a-item-01 m-1011-item-01 m-1011a-item-01 m-0001a-item-01 m-1001-item-01 m-0010a-item-01 m-0011a-item-01 m-1100-item-01 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.6312, -0.0864, 0.0432) m at first
    (pushes item-01 m-0100a-item-01) (pushes item-01 m-0110a-item-01) (pushes item-01 m-0111a-item-01) (pushes item-01 m-1111a-item-01) (pushes item-01 m-0000a-item-01) (pushes item-01 m-1011-item-01) (pushes item-01 m-1011a-item-01) (pushes item-01 m-0001a-item-01) (pushes item-01 m-1001-item-01) (pushes item-01 m-0010a-item-01) (pushes item-01 m-0011a-item-01) (pushes item-01 m-1100-item-01)
    (= (x item-01) 2812) (= (y item-01) 2136) (= (z item-01) 0)
    (= (along-x m-0100a-item-01) 9336) (= (along-y m-0100a-item-01) 9611) (= (along-z m-0100a-item-01) 10000)
    (= (along-x m-0110a-item-01) 9737) (= (along-y m-0110a-item-01) 9938) (= (along-z m-0110a-item-01) 10000)
    (= (along-x m-0111a-item-01) 9388) (= (along-y m-0111a-item-01) 10128) (= (along-z m-0111a-item-01) 10000)
    (= (along-x m-1111a-item-01) 9832) (= (along-y m-1111a-item-01) 10153) (= (along-z m-1111a-item-01) 10000)
    (= (along-x m-0000a-item-01) 9696) (= (along-y m-0000a-item-01) 9447) (= (along-z m-0000a-item-01) 10000)
    (= (along-x m-1011-item-01) 10627) (= (along-y m-1011-item-01) 10092) (= (along-z m-1011-item-01) 10000)
    (= (along-x m-1011a-item-01) 10714) (= (along-y m-1011a-item-01) 9855) (= (along-z m-1011a-item-01) 10000)
    (= (along-x m-0001a-item-01) 10150) (= (along-y m-0001a-item-01) 10131) (= (along-z m-0001a-item-01) 10000)
    (= (along-x m-1001-item-01) 10107) (= (along-y m-1001-item-01) 10128) (= (along-z m-1001-item-01) 10000)
    (= (along-x m-0010a-item-01) 10186) (= (along-y m-0010a-item-01) 9727) (= (along-z m-0010a-item-01) 10000)
    (= (along-x m-0011a-item-01) 10110) (= (along-y m-0011a-item-01) 10503) (= (along-z m-0011a-item-01) 10000)
    (= (along-x m-1100-item-01) 9999) (= (along-y m-1100-item-01) 9486) (= (along-z m-1100-item-01) 10000)
    (= (total-cost) 0) (= (cost m-0100a-item-01) 14) (= (cost m-0110a-item-01) 4) (= (cost m-0111a-item-01) 4) (= (cost m-1111a-item-01) 4) (= (cost m-0000a-item-01) 97) (= (cost m-1011-item-01) 17) (= (cost m-1011a-item-01) 14) (= (cost m-0001a-item-01) 7) (= (cost m-1001-item-01) 4) (= (cost m-0010a-item-01) 4) (= (cost m-0011a-item-01) 4) (= (cost m-1100-item-01) 10)
  )
  (:goal (and (<= (x item-01) 3832) (>= (x item-01) 2922) (<= (+ (x item-01) (y item-01)) 6384) (>= (+ (x item-01) (y item-01)) 5097) (<= (y item-01) 2818) (>= (y item-01) 1909) (<= (+ (y item-01) 370) (x item-01)) (<= (x item-01) (+ (y item-01) 1657)) (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
