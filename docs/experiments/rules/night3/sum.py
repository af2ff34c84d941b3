import json,sys,re,collections
F={"own":394.9,"terrace":838.8,"statue":460.8,"flowers":539.0,"showroom":1024,"campsite":1091}
for f in sys.argv[1:]:
    f=f.replace('.json','')
    try: d=json.load(open(f+'.json'))
    except Exception as e: print(f,'?',open(f+'.err').read()[:200] if __import__('os').path.exists(f+'.err') else ''); continue
    b=d['bytes']; t=sum(b.values())/1e6
    fl=[v for k,v in F.items() if f.startswith(k)][0]
    err=open(f+'.err').read()
    sp=set(re.findall(r'window (\d+) mark',err)); n=len(re.findall(r'^spill',err,re.M))
    ws=set(re.findall(r'^spill .* walk (\d+) window',err,re.M))
    print(f"{f:26s} {d['cycles']/1e3:9,.0f} k x{d['cycles']/1e3/fl:5.2f} {t:6.1f} MB "+' '.join(f"{k} {v/1e6:.1f}" for k,v in b.items() if v>5e4)+f" walks {d['walks']} split {d['split']} | spills {n} walks {len(ws)} windows {len(sp)}")
