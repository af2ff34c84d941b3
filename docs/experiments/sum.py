import json,sys,glob,re
F={"own":394.9,"terrace":838.8,"statue":460.8,"flowers":539.0,"showroom":1024,"campsite":1091}
for f in sys.argv[1:]:
    try: d=json.load(open(f))
    except Exception as e: print(f,"?"); continue
    for x in d["designs"]:
        b=x["bytes"]; t=sum(v["read"]+v["written"] for v in b.values())/1e6
        so=sum(b["sort_overflow"].values())/1e6 if "sort_overflow" in b else 0
        fl=[v for k,v in F.items() if k in f]
        print(f"{f:34s}  {x['cycles']:>10,} x{x['cycles']/1e3/fl[0] if fl else 0:5.2f} {t:6.1f} MB sort {so:5.1f} geo {b['geometry']['read']/1e6:5.1f} col {b['color']['read']/1e6:5.1f} nod {b['nodes']['read']/1e6:5.1f} vis {x['visible']:,}")
